import { LogLevel, type Init, type LogTail as LogTailMessage } from '@ubii/proto';
import { oneLine } from '../one-line.ts';
import type { Log, LogFields } from '../ports/log.ts';

/** Lines that are kept [EX-37]: some 200 KB at most in practice. */
const KEPT_LINES = 1_000;
/** Fields of one line, and characters of one text [EX-37]. */
const MAX_FIELDS = 20;
const MAX_TEXT_LENGTH = 1_000;
/** Line numbers of one run of the master: those of the next begin behind them. */
const LINES_PER_MS = 1_000;

type LevelName = 'error' | 'warn' | 'info' | 'debug';

const LEVELS: Readonly<Record<LevelName, LogLevel>> = {
  error: LogLevel.LOG_ERROR,
  warn: LogLevel.LOG_WARN,
  info: LogLevel.LOG_INFO,
  debug: LogLevel.LOG_DEBUG,
};

/** What must not be shown to whoever may read the log [EX-39]. */
const SECRET_NAME = /token|key|passw|secret|cookie|authorization/i;
const SECRET_PARAMETER =
  /\b([\w-]*(?:token|key|passw\w*|secret|cookie|authorization))(=|: ?)[^\s&"',;)]+/gi;

interface KeptLine {
  readonly number: number;
  readonly timeMs: number;
  readonly level: LogLevel;
  readonly message: string;
  readonly fields: { name: string; value: string }[];
}

/** What all children of one log share. */
interface Ring {
  readonly lines: KeptLine[];
  readonly firstNumber: number;
  lastNumber: number;
  readonly keepsDebug: boolean;
  readonly nowMs: () => number;
}

/** A log that also keeps its last lines, for people who cannot see where it is written [EX-37]. */
export class LogTail implements Log {
  readonly #inner: Log;
  readonly #ring: Ring;
  readonly #fields: LogFields;

  /**
   * @param inner Where the lines are written.
   * @param nowMs Epoch milliseconds.
   * @param keepsDebug Whether debug lines are kept as well [EX-38].
   */
  constructor(inner: Log, nowMs: () => number, keepsDebug: boolean);
  constructor(inner: Log, ring: Ring, fields: LogFields);
  constructor(inner: Log, ring: Ring | (() => number), third: boolean | LogFields) {
    this.#inner = inner;
    if (typeof ring === 'function') {
      const firstNumber = Math.floor(ring()) * LINES_PER_MS;
      this.#ring = {
        lines: [],
        firstNumber,
        lastNumber: firstNumber,
        keepsDebug: third === true,
        nowMs: ring,
      };
      this.#fields = {};
    } else {
      this.#ring = ring;
      this.#fields = third as LogFields;
    }
  }

  error(message: string, fields?: LogFields): void {
    this.#keep('error', message, fields);
    this.#inner.error(message, fields);
  }

  warn(message: string, fields?: LogFields): void {
    this.#keep('warn', message, fields);
    this.#inner.warn(message, fields);
  }

  info(message: string, fields?: LogFields): void {
    this.#keep('info', message, fields);
    this.#inner.info(message, fields);
  }

  debug(message: string, fields?: LogFields): void {
    if (this.#ring.keepsDebug) this.#keep('debug', message, fields);
    this.#inner.debug(message, fields);
  }

  child(fields: LogFields): Log {
    return new LogTail(this.#inner.child(fields), this.#ring, { ...this.#fields, ...fields });
  }

  /**
   * Lines after the cursor of an earlier reply, oldest first [EX-37].
   * @param cursor 0 for all.
   * @param level The least severe that is wanted.
   * @param count Lines wanted at most, the newest; 0 for all that are kept.
   */
  read(cursor: number, level: LogLevel, count: number): Init<LogTailMessage> {
    const { lines, firstNumber, lastNumber } = this.#ring;
    const isKnown = cursor >= firstNumber && cursor <= lastNumber;
    const after = isKnown ? cursor : firstNumber;
    const wanted = lines.filter((line) => line.number > after && line.level <= level);
    const most = count > 0 ? Math.min(count, KEPT_LINES) : KEPT_LINES;
    const told = wanted.slice(-most);
    const firstKept = lines[0]?.number ?? lastNumber + 1;
    const forgotten = Math.max(0, firstKept - 1 - after);
    return {
      cursor: lastNumber,
      reset: !isKnown,
      missed: forgotten + wanted.length - told.length,
      lines: told,
    };
  }

  #keep(level: LevelName, message: string, fields: LogFields = {}): void {
    const ring = this.#ring;
    ring.lines.push({
      number: ++ring.lastNumber,
      timeMs: ring.nowMs(),
      level: LEVELS[level],
      message: withoutSecrets(message),
      fields: keptFields({ ...this.#fields, ...fields }),
    });
    if (ring.lines.length > KEPT_LINES) ring.lines.shift();
  }
}

/** [EX-39] */
function keptFields(fields: LogFields): KeptLine['fields'] {
  const kept: KeptLine['fields'] = [];
  for (const [name, value] of Object.entries(fields)) {
    if (value === undefined || name === 'stack') continue;
    const text = SECRET_NAME.test(name) ? '***' : withoutSecrets(String(value));
    if (kept.push({ name, value: text }) >= MAX_FIELDS) break;
  }
  return kept;
}

function withoutSecrets(text: string): string {
  return oneLine(text, MAX_TEXT_LENGTH).replace(SECRET_PARAMETER, '$1$2***');
}
