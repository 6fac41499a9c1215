import { isLogged, type LogLevel } from '@ubii/program';

/** Logs one line. */
export type Log = (level: LogLevel, message: string) => void;

/** @param write takes one line, without the line break */
export function createLog(least: LogLevel, write: (line: string) => void, nowMs = Date.now): Log {
  return (level, message) => {
    if (!isLogged(level, least)) return;
    const time = new Date(nowMs()).toISOString().slice(11, 19);
    write(`${time} ${level.padEnd(5)} ${printable(message)}`);
  };
}

/** Removes control characters: messages contain texts of modules and of the master. */
function printable(text: string): string {
  return text.replace(/\p{Cc}/gu, (control) => (control === '\n' ? '\n      ' : ''));
}
