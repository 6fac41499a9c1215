/** What the sentence is made from. */
export interface HomeFacts {
  /** Clients that are there, this page included. */
  readonly active: number;
  /** Clients that went silent a moment ago. */
  readonly silent: number;
  readonly errors: number;
  readonly warnings: number;
  /** Sessions that run, or are held. */
  readonly running: number;
  /** Modules of them that do not do what they should. */
  readonly troubledModules: number;
  /** Records per second; `undefined` when the master does not tell. */
  readonly recordsPerSecond: number | undefined;
}

/** The one true sentence: what is, and, dimmer, what it asks of the reader. */
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
const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

function whatIs({ active, running, recordsPerSecond }: HomeFacts): string {
  if (running > 0) {
    const whom = active <= 1 ? 'this browser alone' : `${inWords(active)} clients`;
    const verb = running === 1 ? 'session is' : 'sessions are';
    return `${capital(inWords(running))} ${verb} running for ${whom}.`;
  }
  if (active <= 1) return 'Only this browser is here.';
  const here = `${capital(inWords(active))} clients are here`;
  if (recordsPerSecond === undefined) return `${here}.`;
  return recordsPerSecond < 0.5 ? `${here}, nobody is publishing.` : `${here} and data is flowing.`;
}

function whatAsks(facts: HomeFacts): string | undefined {
  const { active, running, troubledModules, silent, errors, warnings } = facts;
  const needs = (count: number, thing: string): string =>
    `${capital(inWords(count))} ${thing}${count === 1 ? ' needs' : 's need'} you.`;
  if (troubledModules > 0 && errors === 0) return needs(troubledModules, 'module');
  if (errors > 0) return needs(errors, 'problem');
  if (silent > 0) return `${capital(inWords(silent))} went silent.`;
  if (warnings > 0) return needs(warnings, 'warning');
  if (active <= 1 && running === 0) return 'Connect a phone or open an example.';
  return undefined;
}

export function homeSentence(facts: HomeFacts): HomeSentence {
  const asks = whatAsks(facts);
  return asks === undefined ? { is: whatIs(facts) } : { is: whatIs(facts), asks };
}
