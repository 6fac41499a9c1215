import { capitalised, plural } from '@ubii/words';
import { inWords } from './in-words.ts';

/** Facts for the sentence. */
export interface HomeFacts {
  /** Number of connected clients, including this page. */
  readonly active: number;
  /** Number of clients that lost their connection recently. */
  readonly silent: number;
  /** Numbers of rows in the list of problems, but for the errors of sessions, which are counted by `troubled`. */
  readonly errors: number;
  readonly warnings: number;
  /** Number of cards. */
  readonly running: number;
  /** Number of cards with a warning. */
  readonly troubled: number;
  /** Records per second; `undefined` when the master does not report it. */
  readonly recordsPerSecond: number | undefined;
}

/** First sentence of the start page: the status, and dimmed what needs attention. */
export interface HomeSentence {
  readonly is: string;
  readonly asks?: string;
}

function whatIs({ active, running, recordsPerSecond }: HomeFacts): string {
  if (running > 0) {
    const clients = active <= 1 ? 'this browser only' : `${inWords(active)} clients`;
    const sessions = `${inWords(running)} ${plural(running, 'session runs', 'sessions run')}`;
    return `${capitalised(sessions)} for ${clients}.`;
  }
  if (active <= 1) return 'Only this browser is connected.';
  const here = `${capitalised(inWords(active))} clients are connected`;
  if (recordsPerSecond === undefined) return `${here}.`;
  return recordsPerSecond < 0.5
    ? `${here}, and none publishes data.`
    : `${here} and data is flowing.`;
}

function whatAsks({ running, troubled, silent, errors, warnings }: HomeFacts): string | undefined {
  const needs = (count: number, things: string): string =>
    `${capitalised(inWords(count))}${things} ${plural(count, 'needs', 'need')} attention.`;
  if (errors > 0) return needs(errors, plural(errors, ' problem'));
  if (troubled > 0) return running === 1 ? 'It needs attention.' : needs(troubled, '');
  if (silent > 0) {
    return plural(
      silent,
      'One client lost its connection.',
      `${capitalised(inWords(silent))} clients lost their connection.`,
    );
  }
  return warnings > 0 ? needs(warnings, plural(warnings, ' warning')) : undefined;
}

/** Says how things are, in the numbers of the cards and problems below. */
export function homeSentence(facts: HomeFacts): HomeSentence {
  const asks = whatAsks(facts);
  return asks === undefined ? { is: whatIs(facts) } : { is: whatIs(facts), asks };
}
