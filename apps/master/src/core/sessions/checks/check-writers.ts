import { quote } from '../../texts/quote.ts';
import { warningProblem } from '../problems.ts';
import { about, type Check } from './check-context.ts';

/** Topics with more than one writer [SE-5]. */
export const checkWriters: Check = function* (modules) {
  const writers = new Map<string, string>();
  for (const draft of modules) {
    for (const [index, { topic }] of draft.mapping.outputMappings.entries()) {
      if (topic === undefined || topic === '') continue;
      const other = writers.get(topic);
      if (other !== undefined) {
        yield warningProblem({
          ...about(draft),
          code: 'topic_written_twice',
          message: `Both ${quote(other)} and ${quote(draft.spec.name)} write ${quote(topic)}. The last value written counts.`,
          path: `${draft.mappingPath}.outputMappings[${index}].topic`,
        });
      }
      writers.set(topic, draft.spec.name);
    }
  }
};
