"""What an FMU says about itself: ``modelDescription.xml``, and how its sources are compiled."""

import xml.etree.ElementTree as ElementTree
from collections.abc import Sequence

from c_runtime.fmi.variables import STATUSES, UNITS, Variable
from sailnet import __version__
from sailnet.mission.mission import Mission
from sailnet.physics.units import TU

FMI = "3.0"
WARNINGS = ("logStatusWarning", "logStatusDiscard", "logStatusError")

NOTE = (
    "Neural guidance of a solar sail, in {precision}, of mission {mission}. A command is for the state that "
    "is the input as a step begins: let this FMU step before the plant does."
)


def model_description(
    mission: Mission, precision: str, listed: Sequence[Variable], token: str, identifier: str
) -> bytes:
    """``modelDescription.xml``."""
    root = ElementTree.Element(
        "fmiModelDescription",
        fmiVersion=FMI,
        modelName=f"sailnet guidance, {mission.title}",
        instantiationToken=token,
        description=NOTE.format(precision=precision, mission=mission.name),
        version=__version__,
        license="MIT",
        generationTool=f"sailnet {__version__}",
        variableNamingConvention="flat",
    )
    ElementTree.SubElement(
        root,
        "CoSimulation",
        modelIdentifier=identifier,
        canHandleVariableCommunicationStepSize="true",
        canGetAndSetFMUState="true",
        canSerializeFMUState="true",
    )
    _units(ElementTree.SubElement(root, "UnitDefinitions"))
    types = ElementTree.SubElement(root, "TypeDefinitions")
    status = ElementTree.SubElement(types, "EnumerationType", name="Status")
    for name, value in STATUSES.items():
        ElementTree.SubElement(status, "Item", name=name, value=str(value))
    categories = ElementTree.SubElement(root, "LogCategories")
    for name in WARNINGS:
        ElementTree.SubElement(categories, "Category", name=name)
    ElementTree.SubElement(
        root,
        "DefaultExperiment",
        startTime="0",
        stopTime=repr(mission.flight.longest * TU),
        stepSize=repr(mission.flight.period * TU),
    )
    described = ElementTree.SubElement(root, "ModelVariables")
    structure = ElementTree.SubElement(root, "ModelStructure")
    for reference, variable in enumerate(listed):
        _variable(described, variable, reference)
        if variable.causality == "output":
            ElementTree.SubElement(structure, "Output", valueReference=str(reference))
    for reference, variable in enumerate(listed):
        if variable.causality == "output":
            ElementTree.SubElement(structure, "InitialUnknown", valueReference=str(reference))
    return _written(root)


def build_description(identifier: str, sources: Sequence[str], defines: Sequence[str]) -> bytes:
    """``sources/buildDescription.xml``; the standard's headers come with the tool that compiles."""
    root = ElementTree.Element("fmiBuildDescription", fmiVersion=FMI)
    made = ElementTree.SubElement(root, "BuildConfiguration", modelIdentifier=identifier)
    files = ElementTree.SubElement(made, "SourceFileSet", language="C99")
    for name in sources:
        ElementTree.SubElement(files, "SourceFile", name=name)
    for option in defines:
        ElementTree.SubElement(files, "PreprocessorDefinition", name=option.removeprefix("-D"), value="1")
    return _written(root)


def _units(definitions: ElementTree.Element) -> None:
    for name, unit in UNITS.items():
        defined = ElementTree.SubElement(definitions, "Unit", name=name)
        exponents = {symbol: str(exponent) for symbol, exponent in unit.exponents.items()}
        ElementTree.SubElement(defined, "BaseUnit", exponents, factor=repr(unit.factor))
        for shown, factor in unit.shown.items():
            ElementTree.SubElement(defined, "DisplayUnit", name=shown, factor=repr(factor))


def _variable(described: ElementTree.Element, variable: Variable, reference: int) -> None:
    variability = {"independent": "continuous", "parameter": "fixed"}.get(variable.causality, "discrete")
    written = ElementTree.SubElement(
        described,
        variable.kind,
        name=variable.name,
        valueReference=str(reference),
        causality=variable.causality,
        variability=variability,
        description=variable.meaning,
    )
    if variable.kind == "Enumeration":
        written.set("declaredType", "Status")
    if variable.unit is not None:
        written.set("unit", variable.unit)
    if variable.start is not None:
        written.set("start", str(variable.start).lower())


def _written(root: ElementTree.Element) -> bytes:
    ElementTree.indent(root)
    text: bytes = ElementTree.tostring(root, "UTF-8", xml_declaration=True)
    return text + b"\n"
