import { LogLevel, type LogLine, type LogTail } from '@ubii/proto';

/** Most lines kept in this page, the same as on the master; older ones are dropped. [EX-37] */
export const MAX_LINES = 1000;

/** Part of the log that this page has. */
export interface KeptLog {
  /** For the next request. */
  readonly cursor: number;
  /** Oldest first. */
  readonly lines: readonly LogLine[];
  /** Number of lines that are no longer available: dropped by the master, or removed here. */
  readonly missed: number;
}

export const EMPTY_LOG: KeptLog = { cursor: 0, lines: [], missed: 0 };

/** Adds a reply. After a restart of the master, the log starts over. */
export function addTail(kept: KeptLog, tail: LogTail): KeptLog {
  const before = tail.reset ? [] : kept.lines;
  const all = [...before, ...tail.lines];
  const lines = all.slice(-MAX_LINES);
  const missed = (tail.reset ? 0 : kept.missed) + tail.missed + (all.length - lines.length);
  return { cursor: tail.cursor, lines, missed };
}

/** Levels from most to least severe, as words. */
export const LEVELS: readonly { readonly level: LogLevel; readonly word: string }[] = [
  { level: LogLevel.LOG_ERROR, word: 'error' },
  { level: LogLevel.LOG_WARN, word: 'warn' },
  { level: LogLevel.LOG_INFO, word: 'info' },
  { level: LogLevel.LOG_DEBUG, word: 'debug' },
];

export const levelWord = (level: LogLevel): string =>
  LEVELS.find((one) => one.level === level)?.word ?? String(level);

/** Lines of at least a level that match every word of a search in message, names or values. */
export function filterLines(
  lines: readonly LogLine[],
  level: LogLevel,
  search: string,
): readonly LogLine[] {
  const words = search.toLowerCase().split(/\s+/).filter(Boolean);
  return lines.filter((line) => {
    if (line.level > level) return false;
    if (words.length === 0) return true;
    const fields = line.fields.map(({ name, value }) => `${name}=${value}`).join(' ');
    const text = `${line.message} ${fields}`.toLowerCase();
    return words.every((word) => text.includes(word));
  });
}

/** Formats a line as text, for copying. */
export function lineText({ timeMs, level, message, fields }: LogLine): string {
  const values = fields.map(({ name, value }) => ` ${name}=${quoted(value)}`).join('');
  const word = levelWord(level).toUpperCase().padEnd(5);
  return `${new Date(timeMs).toISOString()} ${word} ${message}${values}`;
}

const quoted = (value: string): string =>
  /^[^\s"=]+$/.test(value) ? value : JSON.stringify(value);

/** Formats several lines. */
export const linesText = (lines: readonly LogLine[]): string =>
  lines.map((line) => `${lineText(line)}\n`).join('');
