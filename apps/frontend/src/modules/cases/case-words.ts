import { counted } from '@ubii/words';
import type { TopicOutputs } from './compare-outputs.ts';
import { EDGE_OUTPUTS } from './compare-outputs.ts';
import type { ModuleCase } from './module-case.ts';

/** What is in a case: `12 s with 120 inputs and 40 outputs`. */
export function caseFacts({ durationMs, inputs, outputs }: ModuleCase): string {
  const seconds = (durationMs / 1000).toFixed(1);
  return `${seconds} s with ${counted(inputs.length, 'input')} and ${counted(outputs.length, 'output')}`;
}

/** How the outputs of a topic compare: `38 as recorded, 2 different`. */
export function outputFacts({ matched, different, missing, additional }: TopicOutputs): string {
  const isEdge = missing + additional <= EDGE_OUTPUTS;
  return [
    `${matched} as recorded`,
    different > 0 ? `${different} different` : '',
    missing > 0 ? `${missing} missing` : '',
    additional > 0 ? `${additional} additional` : '',
    isEdge && missing + additional > 0 ? 'at the edges of the span, which is accepted' : '',
  ]
    .filter(Boolean)
    .join(', ');
}

/** The first output that differs. */
export function differenceWords({ first }: TopicOutputs): string | undefined {
  if (first === undefined) return undefined;
  const { atMs, path, recorded, now } = first;
  const text = (value: unknown): string => JSON.stringify(value) ?? 'nothing';
  return `At ${(atMs / 1000).toFixed(3)} s ${path} is ${text(now)}; recorded: ${text(recorded)}.`;
}
