import { counted } from '@ubii/words';
import type { TopicRecord } from '@ubii/proto';
import type { TopicComparison } from '@ubii/recording/compare';
import { caseTimeMs, EDGE_OUTPUTS, isSame } from './compare-outputs.ts';
import type { ModuleCase } from './module-case.ts';

/** What is in a case: `12 s with 120 inputs and 40 outputs`. */
export function caseFacts({ durationMs, inputs, outputs }: ModuleCase): string {
  const seconds = (durationMs / 1000).toFixed(1);
  return `${seconds} s with ${counted(inputs.length, 'input')} and ${counted(outputs.length, 'output')}`;
}

/** How the outputs of a topic compare: `38 as recorded, 2 different`. */
export function outputFacts(outputs: TopicComparison): string {
  const { same, different, missing, additional, atEdges } = outputs;
  const isEdge = atEdges > 0 && missing + additional === atEdges && atEdges <= EDGE_OUTPUTS;
  return [
    `${same} as recorded`,
    different > 0 ? `${different} different` : '',
    missing > 0 ? `${missing} missing` : '',
    additional > 0 ? `${additional} additional` : '',
    isEdge ? 'at the edges of the span, which is accepted' : '',
  ]
    .filter(Boolean)
    .join(', ');
}

/** The first output that differs, unless all are as recorded. */
export function differenceWords(outputs: TopicComparison): string | undefined {
  const [first] = outputs.differences;
  if (first === undefined || isSame(outputs)) return undefined;
  const { kind, timeNs, path, recorded, rerun } = first;
  const at = `At ${(caseTimeMs(timeNs) / 1000).toFixed(3)} s`;
  const format = (recorded ?? rerun)?.format ?? '';
  if (kind === 'missing') return `${at} an output is missing. Recorded: ${textOf(recorded, '')}.`;
  if (kind === 'additional') return `${at} there is an additional output: ${textOf(rerun, '')}.`;
  const member = path === '' ? format : `${format}.${path}`;
  return `${at} ${member} is ${textOf(rerun, path)}; recorded: ${textOf(recorded, path)}.`;
}

/** The member of a value, in one line. */
function textOf(record: TopicRecord | undefined, path: string): string {
  let member: unknown = record?.value;
  for (const name of path === '' ? [] : path.split('.'))
    member = (member as Readonly<Record<string, unknown>> | undefined)?.[name];
  if (ArrayBuffer.isView(member)) return counted(member.byteLength, 'byte');
  return (
    JSON.stringify(member, (_, value: unknown) => (ArrayBuffer.isView(value) ? '…' : value)) ??
    'nothing'
  );
}
