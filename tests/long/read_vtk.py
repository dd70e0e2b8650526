"""Prints what VTK's own reader finds in the files that a .pvd lists: one line per file and per array.

Usage: read_vtk.py FILE.pvd. Ends with 3 when the package python3-vtk9 is missing, with 1 when a file is bad.
"""
import os
import sys
import xml.etree.ElementTree as xml

try:
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError as error:
    print(error, file=sys.stderr)
    sys.exit(3)


def show(name, array):
    """Name, type, components and all numbers, in digits that read back as the same number."""
    values = [
        f"{array.GetComponent(i, k):.17g}"
        for i in range(array.GetNumberOfTuples())
        for k in range(array.GetNumberOfComponents())
    ]
    print("array", name, array.GetDataTypeAsString().replace(" ", "_"), array.GetNumberOfComponents(), *values)


def read(path):
    reader = vtkXMLPolyDataReader()
    complaints = []
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda caller, name: complaints.append(name))
    reader.SetFileName(path)
    if not reader.CanReadFile(path):
        sys.exit(f"{path}: not a file of this reader")
    reader.Update()
    if complaints or reader.GetErrorCode() != 0:
        sys.exit(f"{path}: the reader complains: {complaints}, code {reader.GetErrorCode()}")
    return reader.GetOutput()


def main(pvd):
    root = xml.parse(pvd).getroot()
    assert root.tag == "VTKFile" and root.get("type") == "Collection", root.attrib
    for entry in root.find("Collection"):
        data = read(os.path.join(os.path.dirname(pvd), entry.get("file")))
        print("file", entry.get("file"), entry.get("timestep"), entry.get("part"), entry.get("name"))
        print("cells", data.GetNumberOfPoints(), data.GetNumberOfVerts(), data.GetNumberOfCells())
        if data.GetNumberOfPoints() > 0:
            show("Points", data.GetPoints().GetData())
        vertices = [data.GetCell(i).GetPointId(0) for i in range(data.GetNumberOfCells())]
        print("array vertices cells 1", *vertices)
        for i in range(data.GetPointData().GetNumberOfArrays()):
            array = data.GetPointData().GetArray(i)
            show(array.GetName(), array)
        for i in range(data.GetFieldData().GetNumberOfArrays()):
            array = data.GetFieldData().GetArray(i)
            show(array.GetName(), array)


if __name__ == "__main__":
    main(sys.argv[1])
