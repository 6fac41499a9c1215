import { quote } from '../../topics/topic-names.ts';
import { warningProblem } from '../problems.ts';
import { about, type Check } from './check-context.ts';

/** Topics with more than one writer, and outputs with no topic [SE-5]. */
export const checkOutputs: Check = function* (modules) {
  const writers = new Map<string, string>();
  for (const draft of modules) {
    const mapped = new Set<string>();
    for (const [index, { outputName, topic }] of draft.mapping.outputMappings.entries()) {
      mapped.add(outputName);
      if (topic === undefined || topic === '') continue;
      const other = writers.get(topic);
      if (other !== undefined) {
        yield warningProblem({
          ...about(draft),
          code: 'topic_written_twice',
          message: `Both ${quote(other)} and ${quote(draft.spec.name)} write ${quote(topic)}; whoever writes last wins.`,
          path: `${draft.mappingPath}.outputMappings[${index}].topic`,
        });
      }
      writers.set(topic, draft.spec.name);
    }
    for (const [index, { internalName }] of draft.spec.outputs.entries()) {
      if (mapped.has(internalName)) continue;
      yield warningProblem({
        ...about(draft),
        code: 'output_not_mapped',
        message: `The output ${quote(internalName)} of ${quote(draft.spec.name)} is mapped to no topic, so nobody gets it.`,
        path: `${draft.path}.outputs[${index}]`,
      });
    }
  }
};
