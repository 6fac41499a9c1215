import { capitalised, plural } from '@ubii/words';

/** Facts for the sentence. */
export interface HomeFacts {
  /** Number of connected clients, including this page. */
  readonly active: number;
  /** Number of clients that lost their connection recently. */
  readonly silent: number;
  readonly errors: number;
  readonly warnings: number;
  /** Number of sessions that run or are paused. */
  readonly running: number;
  /** Number of their modules with an error. */
  readonly troubledModules: number;
  /** Records per second; `undefined` when the master does not report it. */
  readonly recordsPerSecond: number | undefined;
}

/** First sentence of the start page: the status, and dimmed what needs attention. */
export interface HomeSentence {
  readonly is: string;
  readonly asks?: string;
}

const WORDS = [
  'no',
  'one',
  'two',
  'three',
  'four',
  'five',
  'six',
  'seven',
  'eight',
  'nine',
  'ten',
  'eleven',
  'twelve',
];

const inWords = (count: number): string => WORDS[count] ?? String(count);

function whatIs({ active, running, recordsPerSecond }: HomeFacts): string {
  if (running > 0) {
    const clients = active <= 1 ? 'this browser only' : `${inWords(active)} clients`;
    const verb = plural(running, 'session is', 'sessions are');
    return `${capitalised(inWords(running))} ${verb} running for ${clients}.`;
  }
  if (active <= 1) return 'Only this browser is connected.';
  const here = `${capitalised(inWords(active))} clients are connected`;
  if (recordsPerSecond === undefined) return `${here}.`;
  return recordsPerSecond < 0.5
    ? `${here}, and none publishes data.`
    : `${here} and data is flowing.`;
}

function whatAsks(facts: HomeFacts): string | undefined {
  const { active, running, troubledModules, silent, errors, warnings } = facts;
  const needs = (count: number, thing: string): string =>
    `${capitalised(inWords(count))} ${plural(count, thing)} ${plural(count, 'needs', 'need')} attention.`;
  if (troubledModules > 0 && errors === 0) return needs(troubledModules, 'module');
  if (errors > 0) return needs(errors, 'problem');
  if (silent > 0) {
    return plural(
      silent,
      'One client lost its connection.',
      `${capitalised(inWords(silent))} clients lost their connection.`,
    );
  }
  if (warnings > 0) return needs(warnings, 'warning');
  if (active <= 1 && running === 0) return 'Connect a phone or open an example.';
  return undefined;
}

export function homeSentence(facts: HomeFacts): HomeSentence {
  const asks = whatAsks(facts);
  return asks === undefined ? { is: whatIs(facts) } : { is: whatIs(facts), asks };
}
