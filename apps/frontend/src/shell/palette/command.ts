import type { Command, CommandKind } from '../../page/command.ts';
import { placeOfWord, queryWords } from '../../ui/find-words.ts';
import { fuzzyScore } from '../../ui/fuzzy.ts';

/** Names of the kinds, at the right edge of a row. */
export const KIND_WORDS: Readonly<Record<CommandKind, string>> = {
  page: 'page',
  example: 'example',
  session: 'session',
  module: 'module',
  client: 'client',
  service: 'service',
  topic: 'topic',
  publish: 'publish',
  action: 'action',
};

/** Bonus by kind. Topics and clients are numerous: they need a better match. */
const KIND_BONUS: Readonly<Record<CommandKind, number>> = {
  page: 20,
  example: 12,
  session: 12,
  module: 8,
  action: 10,
  client: 6,
  service: 0,
  topic: 0,
  publish: 0,
};

/** Kinds that are numerous and shown only when searched for. */
const BY_NAME: ReadonlySet<CommandKind> = new Set([
  'topic',
  'publish',
  'client',
  'session',
  'module',
  'service',
]);

/** What was used lately comes before what fits as well. */
const RECENT_BONUS = 30;
/** Most recently used ones without a query. */
const MAX_RECENT = 6;
/** Most results. */
const MAX_RESULTS = 60;

/** Points of a word of the query, by where it was found. */
const POINTS = { wordOfTitle: 100, wordOfDetail: 50, insideTitle: 30 };
/** For a whole word, and for the first one. */
const WHOLE_BONUS = 20;
const FIRST_BONUS = 10;

/**
 * Returns the commands for a query, best first. Without a query: recently used ones, then pages, examples and actions;
 * topics, clients, sessions, modules and services need a query. Services are found after the word "service" or a slash.
 * @param recent ids, newest first
 */
export function rankCommands(
  query: string,
  commands: readonly Command[],
  recent: readonly string[],
): Command[] {
  const { words, isAsked } = readQuery(query);
  if (words.length === 0) {
    const byId = new Map(commands.map((command) => [command.id, command]));
    const used = recent.map((id) => byId.get(id)).filter((command) => command !== undefined);
    const first = used.slice(0, MAX_RECENT);
    const rest = commands.filter(
      (command) => !BY_NAME.has(command.kind) && !first.includes(command),
    );
    return [...first, ...rest].slice(0, MAX_RESULTS);
  }
  const asked = commands.filter(({ kind }) => isAsked(kind));
  const found = best(asked, recent, (command) => scoreOfWords(words, command));
  if (found.length > 0) return found;
  // Abbreviations: letters in order, which fit much by chance.
  return best(asked, recent, ({ title }) => fuzzyScore(words.join(' '), title));
}

/** The words that are searched for, in lower case, and the kinds of what is searched. */
function readQuery(query: string): {
  readonly words: readonly string[];
  isAsked(kind: CommandKind): boolean;
} {
  const [, slash, service, rest = ''] = /^\s*(?:(\/)|(services?\s+))?(.*)$/is.exec(query) ?? [];
  const words = queryWords(rest);
  if (words.length > 0 && service) return { words, isAsked: (kind) => kind === 'service' };
  if (slash) return { words, isAsked: (kind) => kind === 'service' || kind === 'topic' };
  // Every topic has one: found by its verb, or it would stand beside the topic itself.
  const isPublishing = words.some((word) => word.length > 2 && 'publish'.startsWith(word));
  return {
    words,
    isAsked: (kind) => kind !== 'service' && (kind !== 'publish' || isPublishing),
  };
}

function best(
  commands: readonly Command[],
  recent: readonly string[],
  scoreOf: (command: Command) => number | undefined,
): Command[] {
  return commands
    .flatMap((command) => {
      const score = scoreOf(command);
      if (score === undefined) return [];
      const bonus = KIND_BONUS[command.kind] + (recent.includes(command.id) ? RECENT_BONUS : 0);
      return [{ command, score: score + bonus }];
    })
    .sort((a, b) => b.score - a.score || a.command.title.length - b.command.title.length)
    .slice(0, MAX_RESULTS)
    .map(({ command }) => command);
}

/** Mean points of the words; `undefined` when one is missing. */
function scoreOfWords(words: readonly string[], command: Command): number | undefined {
  const { title, detail = '' } = command;
  let sum = 0;
  for (const word of words) {
    const ofTitle = pointsIn(title, word, POINTS.wordOfTitle);
    const points =
      ofTitle ??
      pointsIn(detail, word, POINTS.wordOfDetail) ??
      (title.toLowerCase().includes(word) ? POINTS.insideTitle : undefined);
    if (points === undefined) return undefined;
    sum += points;
  }
  return sum / words.length - Math.min(title.length, 60) / 10;
}

/** Points for a word of the text that begins so; the best one counts. */
function pointsIn(text: string, word: string, points: number): number | undefined {
  const place = placeOfWord(text, word);
  if (place === undefined) return undefined;
  return points + (place.isWhole ? WHOLE_BONUS : 0) + (place.isFirst ? FIRST_BONUS : 0);
}
