import type { Command, CommandKind } from '../../page/command.ts';
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
};

/** Kinds that are numerous and shown only when searched for. */
const BY_NAME: ReadonlySet<CommandKind> = new Set([
  'topic',
  'client',
  'session',
  'module',
  'service',
]);

const RECENT_BONUS = 15;
/** Most results. */
const MAX_RESULTS = 60;

/**
 * Returns the commands for a query, best first. Without a query: recently used ones, then pages, examples and actions;
 * topics, clients, sessions, modules and services need a query.
 * @param recent ids, newest first
 */
export function rankCommands(
  query: string,
  commands: readonly Command[],
  recent: readonly string[],
): Command[] {
  if (query.trim() === '') {
    const byId = new Map(commands.map((command) => [command.id, command]));
    const first = recent.map((id) => byId.get(id)).filter((command) => command !== undefined);
    const rest = commands.filter(
      (command) => !BY_NAME.has(command.kind) && !recent.includes(command.id),
    );
    return [...first, ...rest].slice(0, MAX_RESULTS);
  }
  return commands
    .map((command) => {
      const title = fuzzyScore(query, command.title);
      const both = fuzzyScore(query, `${command.title} ${command.detail ?? ''}`);
      const found = title ?? (both === undefined ? undefined : both - 20);
      const bonus = KIND_BONUS[command.kind] + (recent.includes(command.id) ? RECENT_BONUS : 0);
      return { command, score: found === undefined ? undefined : found + bonus };
    })
    .filter((entry): entry is { command: Command; score: number } => entry.score !== undefined)
    .sort((a, b) => b.score - a.score || a.command.title.length - b.command.title.length)
    .slice(0, MAX_RESULTS)
    .map(({ command }) => command);
}

const MAX_RECENT = 6;

/** Returns the list of recently used commands after `id` was used. */
export function rememberRecent(recent: readonly string[], id: string): string[] {
  return [id, ...recent.filter((other) => other !== id)].slice(0, MAX_RECENT);
}
