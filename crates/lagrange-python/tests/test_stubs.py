"""The stubs name what the module has, with the parameters of its functions."""

import ast
import inspect
from pathlib import Path

import lagrange
import pytest

STUBS = ast.parse((Path(__file__).parents[1] / "lagrange.pyi").read_text(encoding="utf-8"))
CLASSES = {node.name: node for node in STUBS.body if isinstance(node, ast.ClassDef)}
# Attributes of exceptions are set where they are raised.
OF_TYPES = {name: node for name, node in CLASSES.items() if not issubclass(getattr(lagrange, name), Exception)}


def members(node):
    """Returns the functions and properties of a class in the stubs, by name."""
    return {item.name: item for item in node.body if isinstance(item, ast.FunctionDef)}


def parameters(function):
    """Returns names and kinds of parameters with whether they have defaults, without `self`."""
    arguments = function.args
    places = [argument.arg for argument in arguments.posonlyargs + arguments.args]
    required = len(places) - len(arguments.defaults)
    found = [(name, "place", index >= required) for index, name in enumerate(places) if name != "self"]
    found += [(arguments.vararg.arg, "places", False)] if arguments.vararg else []
    found += [(name.arg, "name", default is not None) for name, default in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    return found + ([(arguments.kwarg.arg, "names", False)] if arguments.kwarg else [])


def parameters_of_module(function):
    kinds = {
        inspect.Parameter.POSITIONAL_ONLY: "place",
        inspect.Parameter.POSITIONAL_OR_KEYWORD: "place",
        inspect.Parameter.VAR_POSITIONAL: "places",
        inspect.Parameter.KEYWORD_ONLY: "name",
        inspect.Parameter.VAR_KEYWORD: "names",
    }
    signature = inspect.signature(function).parameters.values()
    empty = inspect.Parameter.empty
    return [(p.name, kinds[p.kind], p.default is not empty) for p in signature if p.name not in ("self", "slf")]


def test_the_stubs_name_the_classes_of_the_module():
    classes = {name for name, value in vars(lagrange).items() if inspect.isclass(value)}
    assert classes == set(CLASSES)


def test_help_shows_the_descriptions_of_classes_and_of_the_module():
    assert inspect.cleandoc(lagrange.__doc__) == ast.get_docstring(STUBS)
    for name, node in CLASSES.items():
        text = ast.get_docstring(node)
        if text is not None:
            assert inspect.cleandoc(getattr(lagrange, name).__doc__).startswith(text), name
    assert ast.get_docstring(members(CLASSES["System"])["__init__"]) in inspect.cleandoc(lagrange.System.__doc__)


@pytest.mark.parametrize("name", OF_TYPES)
def test_the_stubs_name_the_members_of_classes(name):
    kind, stubs = getattr(lagrange, name), members(OF_TYPES[name])
    own = {member for member in vars(kind) if not member.startswith("_")}
    # Inherited members may be described again.
    assert own <= {member for member in stubs if not member.startswith("_")} <= set(dir(kind))
    for member, stub in stubs.items():
        is_property = any(isinstance(item, ast.Name) and item.id == "property" for item in stub.decorator_list)
        found = inspect.getattr_static(kind, member)
        assert is_property == inspect.isgetsetdescriptor(found), member
        if member in vars(kind) and (text := ast.get_docstring(stub)):
            assert inspect.cleandoc(getattr(kind, member).__doc__) == text, member
        if not is_property and not member.startswith("_"):
            assert parameters(stub) == parameters_of_module(getattr(kind, member)), member
