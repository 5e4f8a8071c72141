"""The stub of the compiled part says what is there."""

import ast
import inspect
import pathlib
import re
import unittest

import moserhex
from moserhex import _moserhex

STUB = ast.parse((pathlib.Path(moserhex.__file__).parent / "_moserhex.pyi").read_text())


def argument_count(function):
    """What pybind11 writes into the first line of the docstring."""
    signature = function.__doc__.splitlines()[0]
    return len(re.findall(r"(?:^|[(,] ?)(\w+): ", signature[signature.index("(") :]))


class Stub(unittest.TestCase):
    def names(self, body):
        return {
            node.name if hasattr(node, "name") else node.target.id
            for node in body
            if isinstance(node, (ast.FunctionDef, ast.ClassDef, ast.AnnAssign))
        }

    def test_names_what_the_module_has(self):
        there = {name for name in vars(_moserhex) if not name.startswith("_")} | {"__version__"}
        self.assertEqual(self.names(STUB.body), there)

    def test_names_what_a_mesh_has(self):
        mesh = next(node for node in STUB.body if isinstance(node, ast.ClassDef) and node.name == "Mesh")
        there = {name for name in vars(_moserhex.Mesh) if not name.startswith("_")}
        self.assertEqual(self.names(mesh.body), there)

    def test_functions_take_as_many_arguments(self):
        for node in STUB.body:
            if isinstance(node, ast.FunctionDef):
                with self.subTest(function=node.name):
                    self.assertEqual(len(node.args.args), argument_count(getattr(_moserhex, node.name)))

    def test_public_names_are_documented_and_typed(self):
        for name in moserhex.__all__:
            item = getattr(moserhex, name)
            if name != "__version__":
                self.assertTrue(item.__doc__, name)
            if inspect.isfunction(item):
                signature = inspect.signature(item)
                self.assertIsNot(signature.return_annotation, signature.empty, name)
                for parameter in signature.parameters.values():
                    self.assertIsNot(parameter.annotation, parameter.empty, f"{name}: {parameter.name}")


if __name__ == "__main__":
    unittest.main()
