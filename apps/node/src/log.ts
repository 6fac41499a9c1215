import { LOG_LEVELS } from './options.ts';
import type { LogLevel } from './options.ts';

/** Tells people what the program does, a line each. */
export type Log = (level: LogLevel, message: string) => void;

/** @param write takes one line, without its end */
export function createLog(least: LogLevel, write: (line: string) => void, nowMs = Date.now): Log {
  return (level, message) => {
    if (LOG_LEVELS.indexOf(level) > LOG_LEVELS.indexOf(least)) return;
    const time = new Date(nowMs()).toISOString().slice(11, 19);
    write(`${time} ${level.padEnd(5)} ${printable(message)}`);
  };
}

/** Texts come from modules and from the master: control characters must not reach a terminal. */
function printable(text: string): string {
  return text.replace(/\p{Cc}/gu, (control) => (control === '\n' ? '\n      ' : ''));
}
