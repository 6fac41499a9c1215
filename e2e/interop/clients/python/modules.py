"""Processing modules of the Python node, written as its documentation says."""

import ubii.proto
from ubii.framework.processing import ProcessingRoutine

DOUBLE = "double"


def _io(name, message_format):
    return ubii.proto.ModuleIO(internal_name=name, message_format=message_format)


class Scale(ProcessingRoutine):
    """
    Puts out three times what comes in.

    The package rewrites this text, and needs it to have several lines.
    """

    def __init__(self, context, mapping=None, eval_strings=False, **kwargs):
        super().__init__(mapping, eval_strings, **kwargs)
        self.name = "py-scale"
        self.tags = ["interop"]
        self.description = "Puts out three times what comes in."
        self.inputs = [_io("value", DOUBLE)]
        self.outputs = [_io("scaled", DOUBLE)]
        if not self.processing_mode:
            self.processing_mode = {"trigger_on_input": {"all_inputs_need_update": True}}

    def on_processing(self, context):
        record = context.inputs.value
        if record is not None:
            context.outputs.scaled = ubii.proto.TopicDataRecord(double=record.double * 3)


MODULES = {"py-scale": Scale}
