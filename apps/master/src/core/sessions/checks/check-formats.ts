import { formatsFit } from '@ubii/pm-sandbox';
import { parseDataFormat, type SessionProblem } from '@ubii/proto';
import { quote } from '../../texts/quote.ts';
import type { DraftModule } from '../complete-modules.ts';
import { errorProblem, warningProblem } from '../problems.ts';
import { about, type Check, type CheckContext } from './check-context.ts';
import { ioOf } from './check-modules.ts';

/**
 * Compares the data format of each input with its sources: other modules, components, the current value. [SE-4] [SE-5]
 */
export const checkFormats: Check = function* (modules, context) {
  for (const draft of modules) {
    for (const [index, { inputName, topic }] of draft.mapping.inputMappings.entries()) {
      if (topic === undefined || topic === '') continue;
      const path = `${draft.mappingPath}.inputMappings[${index}].topic`;
      yield* checkTopic(draft, modules, inputName, topic, path, context);
    }
  }
};

function* checkTopic(
  draft: DraftModule,
  modules: readonly DraftModule[],
  inputName: string,
  topic: string,
  path: string,
  context: CheckContext,
): Iterable<SessionProblem> {
  const declared = parseDataFormat(ioOf(draft.spec.inputs, inputName)?.messageFormat ?? '');
  const found = { ...about(draft), path };
  const input = `the input ${quote(inputName)} of ${quote(draft.spec.name)} expects ${declared}`;
  const writers = writersOf(topic, modules);
  for (const { writer, outputName } of writers) {
    const format = parseDataFormat(ioOf(writer.spec.outputs, outputName)?.messageFormat ?? '');
    if (formatsFit(format, declared)) continue;
    yield errorProblem({
      ...found,
      code: 'format_mismatch',
      message: `The output ${quote(outputName)} of ${quote(writer.spec.name)} outputs ${format} on ${quote(topic)}, but ${input}.`,
    });
  }
  const components = context.publishers(topic);
  for (const { name, messageFormat } of components) {
    const format = parseDataFormat(messageFormat);
    if (formatsFit(format, declared)) continue;
    yield errorProblem({
      ...found,
      code: 'format_mismatch',
      message: `The component ${quote(name)} publishes ${format} on ${quote(topic)}, but ${input}.`,
    });
  }
  if (!context.hasRecord(topic)) {
    // The topic will have a value, because another module of the session writes it.
    if (writers.length > 0) return;
    yield warningProblem({
      ...found,
      code: 'topic_without_record',
      message: `Topic ${context.nameTopic(topic)} has no value, so the input ${quote(inputName)} is empty until one is published.`,
    });
  } else if (writers.length === 0 && components.length === 0) {
    const format = context.retainedFormat(topic);
    if (formatsFit(format, declared)) return;
    yield warningProblem({
      ...found,
      code: 'topic_of_other_format',
      message: `The value on ${quote(topic)} is ${format}, but ${input}. The value is ignored.`,
    });
  }
}

/** Outputs of the session that are mapped to this topic. */
export function writersOf(
  topic: string,
  modules: readonly DraftModule[],
): { writer: DraftModule; outputName: string }[] {
  return modules.flatMap((writer) =>
    writer.mapping.outputMappings
      .filter((mapping) => mapping.topic === topic)
      .map(({ outputName }) => ({ writer, outputName })),
  );
}
