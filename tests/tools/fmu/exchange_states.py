"""Every call in every state of model exchange by FMI 3.0, as states.py tries those of co-simulation:

    exchange_states.py FMU [FMU ...]

The tables are those of the standard (3.0.2: sections 2.3 and 3.2). Prints TAP.
"""
import ctypes
import sys

import check
import states
from exchange import Solved
from importer import NUMBER, REFERENCE, SIZE

# N instantiated, I initialization mode, V event mode, C continuous-time mode, E terminated.
CALLS = """
SetDebugLogging NIVCE, Reset NIVCE, EnterInitializationMode N, ExitInitializationMode I, Terminate VC
GetFMUState NIVCE, SetFMUState NIVCE, FreeFMUState NIVCE, SerializedFMUStateSize NIVCE, SerializeFMUState NIVCE
DeserializeFMUState NIVCE, EnterEventMode C, EnterContinuousTimeMode V, UpdateDiscreteStates V, SetTime C
CompletedIntegratorStep C, SetContinuousStates C, GetContinuousStates IVCE, GetContinuousStateDerivatives IVCE
GetNominalsOfContinuousStates IVCE, GetEventIndicators IVCE, GetDirectionalDerivative IVCE
GetFloat32 NIVCE, GetFloat64 NIVCE, GetInt8 NIVCE, GetUInt8 NIVCE, GetInt16 NIVCE, GetUInt16 NIVCE, GetInt32 NIVCE
GetUInt32 NIVCE, GetInt64 NIVCE, GetUInt64 NIVCE, GetBoolean NIVCE, GetString NIVCE, GetBinary NIVCE
SetFloat32 NIVC, SetFloat64 NIVC, SetInt8 NIVC, SetUInt8 NIVC, SetInt16 NIVC, SetUInt16 NIVC, SetInt32 NIVC
SetUInt32 NIVC, SetInt64 NIVC, SetUInt64 NIVC, SetBoolean NIVC, SetString NIVC, SetBinary NIVC
GetNumberOfEventIndicators NV, GetNumberOfContinuousStates NV
"""
LACKING = """
EnterConfigurationMode ExitConfigurationMode EnterStepMode DoStep EvaluateDiscreteStates GetAdjointDerivative
GetNumberOfVariableDependencies GetVariableDependencies GetOutputDerivatives GetClock SetClock GetIntervalDecimal
GetIntervalFraction GetShiftDecimal GetShiftFraction SetIntervalDecimal SetIntervalFraction SetShiftDecimal
SetShiftFraction ActivateModelPartition
"""


class Exchange(states.Plant):
    """An FMU in model exchange. What stands at the end of a run are the derivatives at its states."""

    def __init__(self, path):
        super().__init__(path)
        self.states, self.table = "NIVCE", states.table_of(CALLS, LACKING)
        self.count = sum(v.element.get("derivative") is not None for v in self.fmu.variables)
        self.good_end = self.finish(self.enter("N"), "N")

    def may_set(self, variable, state):
        is_state, is_input = variable.name.startswith("states."), variable.causality == "input"
        if state in "NI":
            return is_input or variable.element.get("initial") == "exact"
        is_moved = is_state and (state == "C" or (state == "V" and variable.element.get("reinit") != "true"))
        return state in "VC" and (is_input or is_moved) or (state == "V" and variable.causality == "parameter")

    def may_get(self, variable, state):
        return state != "N" or variable.start is not None

    def enter(self, state):
        instance = Solved(self.fmu)
        if state != "N":
            instance.enter()
        if state in "VCE":
            instance.leave()
        if state in "CE":
            instance.call("EnterContinuousTimeMode")
        if state == "E":
            instance.call("Terminate")
        return instance

    def finish(self, instance, state):
        if state == "E":
            instance.call("Reset")
        if state in "EN":
            instance.enter()
        if state in "ENI":
            instance.leave()
        if state != "C":
            instance.call("EnterContinuousTimeMode")
        x = instance.numbers("GetContinuousStates", self.count)
        return (instance.rates([a + 0.125 for a in x]), instance.get(self.output)) if x else None

    def arguments(self, name):
        """Those of the calls of model exchange; None of others."""
        rate = next(v.reference for v in self.fmu.variables if v.element.get("derivative") is not None)
        numbers, count, one = (NUMBER * self.count)(), SIZE(self.count), SIZE(1)
        if name == "GetDirectionalDerivative":
            of, by = (REFERENCE * 1)(rate), (REFERENCE * 1)(rate - self.count)
            return of, one, by, one, (NUMBER * 1)(1.0), one, (NUMBER * 1)(), one
        if name.startswith("GetNumberOf"):
            return (ctypes.byref(SIZE()),)
        if name == "GetEventIndicators":
            return None, SIZE(0)
        return (numbers, count) if "ContinuousState" in name else None


if __name__ == "__main__":
    for archive in sys.argv[1:]:
        tried = Exchange(archive)
        states.test(tried, "%s, model exchange" % tried.fmu.identifier)
    print("1..%d" % check.results)
