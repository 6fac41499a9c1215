import { describeThrown } from './module-error.ts';

/** Methods of a module's console by name, with the level of the line they write. [PM-14] */
export const CONSOLE_LEVELS = {
  log: 'log',
  info: 'info',
  warn: 'warn',
  error: 'error',
  debug: 'debug',
  trace: 'debug',
  dir: 'log',
  table: 'log',
} as const;

/** Other console methods that modules may call; they write nothing. */
export const SILENT_CONSOLE_METHODS = [
  'assert',
  'clear',
  'count',
  'group',
  'groupEnd',
  'time',
  'timeEnd',
] as const;

/** One line of text for what a module gave its console. */
export function formatLog(values: readonly unknown[]): string {
  return values.map(formatValue).join(' ');
}

function formatValue(value: unknown): string {
  if (typeof value === 'string') return value;
  if (value instanceof Error) return describeThrown(value);
  try {
    return (typeof value === 'object' ? JSON.stringify(value) : undefined) ?? String(value);
  } catch (thrown) {
    return `[${describeThrown(thrown)}]`;
  }
}
