"""What the module has and what its stubs declare are the same."""

import ast
import inspect
from pathlib import Path

import sluice

STUBS = ast.parse((Path(sluice.__file__).parent / "__init__.pyi").read_text())


def public(names):
    return {name for name in names if not name.startswith("_")}


def test_every_public_name_is_declared():
    declared = {node.name for node in STUBS.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    declared |= {node.target.id for node in STUBS.body if isinstance(node, ast.AnnAssign)}
    assert public(declared) == public(sluice.__all__)


def test_every_member_is_declared():
    for node in STUBS.body:
        if not isinstance(node, ast.ClassDef):
            continue
        cls = getattr(sluice, node.name)
        declared = {each.name for each in node.body if isinstance(each, ast.FunctionDef)}
        declared |= {each.target.id for each in node.body if isinstance(each, ast.AnnAssign)}
        own = {name for base in cls.__mro__ if base.__module__.startswith("sluice") for name in vars(base)}
        assert public(declared) == public(own), node.name


def test_arguments_are_declared_by_their_names():
    for node in STUBS.body:
        functions = node.body if isinstance(node, ast.ClassDef) else [node]
        for function in functions:
            if not isinstance(function, ast.FunctionDef) or function.decorator_list:
                continue
            owner = getattr(sluice, node.name) if isinstance(node, ast.ClassDef) else sluice
            try:
                known = list(inspect.signature(getattr(owner, function.name)).parameters)
            except (ValueError, TypeError):  # compiled
                continue
            arguments = function.args.posonlyargs + function.args.args
            assert [a.arg for a in arguments] == [name for name in known if name != "paths"], function.name
