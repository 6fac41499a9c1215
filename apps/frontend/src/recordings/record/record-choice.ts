import type { Init, RecordingBudget, RecordingSelection } from '@ubii/proto';

/** What is chosen by in the dialog. */
export type RecordBy = 'all' | 'topics' | 'clients' | 'sessions';

/** What people chose to record. */
export interface RecordChoice {
  readonly by: RecordBy;
  readonly topics: readonly string[];
  /** Topics with wildcards, separated by spaces, commas or lines. */
  readonly patterns: string;
  readonly clients: readonly string[];
  readonly sessions: readonly string[];
  readonly withImages: boolean;
}

/** The choice that nobody has changed yet. */
export const EVERYTHING: RecordChoice = {
  by: 'all',
  topics: [],
  patterns: '',
  clients: [],
  sessions: [],
  withImages: true,
};

/** The selection as the master takes it; empty members select nothing by themselves. */
export function selectionOf(choice: RecordChoice): Init<RecordingSelection> {
  const { by, topics, patterns, clients, sessions, withImages } = choice;
  return {
    ...(by === 'topics' && { topics: [...topics], patterns: splitPatterns(patterns) }),
    ...(by === 'clients' && { clients: [...clients] }),
    ...(by === 'sessions' && { sessions: [...sessions] }),
    withoutImages: !withImages,
  };
}

/** The choice that makes a selection. Of one that names several kinds of things, the first kind stays. */
export function choiceOf(selection: RecordingSelection | undefined): RecordChoice {
  if (selection === undefined) return EVERYTHING;
  const { topics, patterns, clients, sessions, withoutImages } = selection;
  const isOf = (...lists: readonly (readonly string[])[]): boolean =>
    lists.some(({ length }) => length > 0);
  const others = isOf(sessions) ? 'sessions' : 'all';
  const by = isOf(topics, patterns) ? 'topics' : isOf(clients) ? 'clients' : others;
  return {
    by,
    topics,
    patterns: patterns.join(' '),
    clients,
    sessions,
    withImages: !withoutImages,
  };
}

/** Whether something is chosen: a selection without members would record everything. */
export function isChosen(choice: RecordChoice): boolean {
  const { topics, patterns, clients, sessions } = selectionOf(choice);
  return (
    [topics, patterns, clients, sessions].some((list) => (list?.length ?? 0) > 0) ||
    choice.by === 'all'
  );
}

/** Patterns as they are typed: separated by spaces, commas or lines. */
export const splitPatterns = (text: string): string[] => text.split(/[\s,]+/).filter(Boolean);

const MINUTE_MS = 60_000;
const MEGABYTE = 1_000_000;

/** @param minutes as typed; empty for the default of the master, as the size */
export function budgetOf(minutes: string, megabytes: string): Init<RecordingBudget> {
  return {
    maxDurationMs: (Number(minutes) || 0) * MINUTE_MS,
    maxBytes: (Number(megabytes) || 0) * MEGABYTE,
  };
}

/** What is wrong with a number that may be left out. */
export function limitError(text: string): string | undefined {
  const isFine = text.trim() === '' || Number(text) > 0;
  return isFine ? undefined : 'Enter a number above 0, or leave it empty.';
}
