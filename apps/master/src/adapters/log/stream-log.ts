import { isLogged, type LogLevel } from '@ubii/program';
import type { Log, LogFields } from '../../core/ports/index.ts';

export interface LogOptions {
  /** The least severe level that is written. */
  readonly level: LogLevel;
  readonly format: 'text' | 'json';
  /** Takes one line, without its end. */
  readonly write: (line: string) => void;
  /** Milliseconds since the Unix epoch. */
  readonly nowMs: () => number;
}

/** A log that writes lines: JSON objects for machines, or short text for people. */
export class StreamLog implements Log {
  readonly #options: LogOptions;
  readonly #fields: LogFields;

  constructor(options: LogOptions, fields: LogFields = {}) {
    this.#options = options;
    this.#fields = fields;
  }

  error(message: string, fields?: LogFields): void {
    this.#line('error', message, fields);
  }

  warn(message: string, fields?: LogFields): void {
    this.#line('warn', message, fields);
  }

  info(message: string, fields?: LogFields): void {
    this.#line('info', message, fields);
  }

  debug(message: string, fields?: LogFields): void {
    this.#line('debug', message, fields);
  }

  child(fields: LogFields): Log {
    return new StreamLog(this.#options, { ...this.#fields, ...fields });
  }

  #line(level: LogLevel, message: string, fields: LogFields | undefined): void {
    const { level: least, format, write, nowMs } = this.#options;
    if (!isLogged(level, least)) return;
    const time = new Date(nowMs()).toISOString();
    const all = { ...this.#fields, ...fields };
    write(
      format === 'json'
        ? JSON.stringify({ time, level, message, ...all })
        : formatText(time, level, message, all),
    );
  }
}

function formatText(time: string, level: LogLevel, message: string, fields: LogFields): string {
  const { stack, ...others } = fields;
  const words = Object.entries(others).flatMap(([name, value]) =>
    value === undefined ? [] : [`${name}=${quote(value)}`],
  );
  const text = message.replaceAll('\n', ' ');
  const line = [time.slice(11, 19), level.padEnd(5), text, ...words].join(' ');
  return stack === undefined ? line : `${line}\n${String(stack)}`;
}

/** Values come from clients: control characters must not reach a terminal. */
function quote(value: string | number | boolean): string {
  const text = String(value);
  return /^[\w./:@+-]+$/.test(text) ? text : JSON.stringify(text).replace(/\u007f|\u009b/g, '');
}

/**
 * Writes lines, of which those before `open()` wait for it: what the program does while it starts must not stand
 * above what it tells the person who started it.
 */
export class LinesAfter {
  readonly #write: (line: string) => void;
  #waiting: string[] | undefined = [];

  constructor(write: (line: string) => void) {
    this.#write = write;
  }

  write(line: string): void {
    if (this.#waiting === undefined) this.#write(line);
    else this.#waiting.push(line);
  }

  /** Writes what waited, in order. */
  open(): void {
    const waiting = this.#waiting ?? [];
    this.#waiting = undefined;
    for (const line of waiting) this.#write(line);
  }
}
