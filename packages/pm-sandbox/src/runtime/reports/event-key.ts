import { ModuleEventKind, type ModuleEvent } from '@ubii/proto';

/** Numbers that are no part of a name, and what was received: both change from run to run. */
const CHANGING = /got (?:"[^"]*"|\S+)|(?<![\w"'/])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w"'])/g;

/**
 * Equal for events that say the same. Problems that differ only in their numbers do: a mistake is the
 * same one in every run. Log lines have to be equal. [PM-81]
 */
export function eventKey({ kind, phase, message, line, column, level }: ModuleEvent): string {
  const text = kind === ModuleEventKind.LOG ? message : message.replaceAll(CHANGING, '#');
  return `${kind} ${phase} ${line}:${column} ${level} ${text}`;
}
