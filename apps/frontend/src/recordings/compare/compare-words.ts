import type { Replay } from '@ubii/proto';
import { capitalised, counted, plural } from '@ubii/words';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import { formatLength } from '../timeline/recording-time.ts';
import type { ComparedTopic, ListedDifference, SessionComparison } from './compare-messages.ts';

/** Outputs of a topic that differ, in whatever way. */
export const differing = ({ different, missing, additional }: ComparedTopic): number =>
  different + missing + additional;

/** Result of a comparison, one sentence. */
export function resultSentence({ topics }: SessionComparison): string {
  const differences = topics.reduce((sum, topic) => sum + differing(topic), 0);
  const all = topics.reduce((sum, topic) => sum + topic.same, differences);
  if (all === 0) return 'The session wrote no outputs, neither then nor today.';
  if (differences === 0) return `All ${counted(all, 'output')} are the same as recorded.`;
  const verb = plural(differences, 'differs', 'differ');
  return `${formatNumber(differences)} of ${counted(all, 'output')} ${verb} from the recording${kindsOf(topics)}.`;
}

/** How they differ, unless all have another value: an output that is missing says less of a module than another value. */
function kindsOf(topics: readonly ComparedTopic[]): string {
  const sum = (kind: ListedDifference['kind']): number =>
    topics.reduce((total, topic) => total + topic[kind], 0);
  const parts = (['different', 'missing', 'additional'] as const)
    .filter((kind) => sum(kind) > 0)
    .map((kind) => `${formatNumber(sum(kind))} ${PARTS[kind]}`);
  return sum('missing') + sum('additional') === 0 ? '' : `: ${parts.join(', ')}`;
}

const PARTS: Readonly<Record<ListedDifference['kind'], string>> = {
  different: 'in value',
  missing: 'missing',
  additional: 'additional',
};

/** Modules that ran with their recorded code; empty when all have code in the library. */
export function recordedCodeSentence(names: readonly string[]): string {
  if (names.length === 0) return '';
  const who = names.map((name) => `“${name}”`).join(', ');
  const what = plural(names.length, 'is', 'are');
  return `${who} ${what} not in the library and ran with the recorded code.`;
}

/** How far a run is, one sentence. */
export function progressSentence({ session, positionMs, span, rate }: Replay): string {
  const [fromMs, untilMs] = [span?.fromMs ?? 0, span?.untilMs ?? 0];
  const done = formatLength(Math.max(0, positionMs - fromMs));
  const speed = rate === 1 ? '' : ` at ${formatNumber(rate, 2)}×`;
  return `Session “${session?.name ?? ''}” runs with today's modules: ${done} of ${formatLength(untilMs - fromMs)}${speed}.`;
}

const KINDS: Readonly<Record<ListedDifference['kind'], string>> = {
  different: 'differs',
  missing: 'missing today',
  additional: 'additional today',
};

/** What differs, as a word, with the member when it is one of several. */
export const differenceWord = ({ kind, path }: ListedDifference): string =>
  path === '' ? capitalised(KINDS[kind]) : `${path} ${KINDS[kind]}`;
