import { LogLevel, type Init, type LogTail as LogTailMessage } from '@ubii/proto';
import { DEFAULT_LIMITS, type Limits } from '../limits/index.ts';
import type { Log, LogFields } from '../ports/log.ts';
import { LogBudget, type BoundedLine, type LevelName } from './log-budget.ts';

/** Lines that are kept, and characters of all of them [EX-37]. */
const KEPT_LINES = 1_000;
const KEPT_CHARACTERS = 1_000_000;
/** Line numbers of one run of the master: those of the next begin behind them. */
const LINES_PER_MS = 1_000;

const LEVELS: Readonly<Record<LevelName, LogLevel>> = {
  error: LogLevel.LOG_ERROR,
  warn: LogLevel.LOG_WARN,
  info: LogLevel.LOG_INFO,
  debug: LogLevel.LOG_DEBUG,
};

const LEFT_OUT = 'lines of the log were left out: more came than logBytesPerSecond';

/** Text that readers of the log must not see [EX-39]. */
const SECRET_NAME = /token|key|passw|secret|cookie|authorization/i;
const SECRET_PARAMETER =
  /\b([\w-]*(?:token|key|passw\w*|secret|cookie|authorization))(=|: ?)[^\s&"',;)]+/gi;

interface KeptLine {
  readonly number: number;
  readonly timeMs: number;
  readonly level: LogLevel;
  readonly message: string;
  readonly fields: { name: string; value: string }[];
  /** Characters of all its texts. */
  readonly length: number;
}

/** State that all children of one log share. */
interface Ring {
  readonly lines: KeptLine[];
  /** Characters of all lines. */
  length: number;
  readonly budget: LogBudget;
  readonly firstNumber: number;
  lastNumber: number;
  readonly keepsDebug: boolean;
  readonly nowMs: () => number;
}

/** A log of bounded lines that also keeps the last ones, for people who cannot see where it is written [EX-37] [EX-72]. */
export class LogTail implements Log {
  readonly #inner: Log;
  readonly #ring: Ring;
  readonly #fields: LogFields;

  /**
   * @param inner Where the lines are written.
   * @param nowMs Epoch milliseconds.
   * @param keepsDebug Whether debug lines are kept as well [EX-38].
   * @param limits Default: those of the table.
   */
  constructor(inner: Log, nowMs: () => number, keepsDebug: boolean, limits?: Limits);
  constructor(inner: Log, ring: Ring, fields: LogFields);
  constructor(
    inner: Log,
    ring: Ring | (() => number),
    third: boolean | LogFields,
    limits: Limits = DEFAULT_LIMITS,
  ) {
    this.#inner = inner;
    if (typeof ring === 'function') {
      const firstNumber = Math.floor(ring()) * LINES_PER_MS;
      this.#ring = {
        lines: [],
        length: 0,
        budget: new LogBudget(limits, ring()),
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
    this.#write('error', message, fields);
  }

  warn(message: string, fields?: LogFields): void {
    this.#write('warn', message, fields);
  }

  info(message: string, fields?: LogFields): void {
    this.#write('info', message, fields);
  }

  debug(message: string, fields?: LogFields): void {
    this.#write('debug', message, fields);
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
      lines: told.map(({ length: _length, ...line }) => line),
    };
  }

  #write(level: LevelName, message: string, fields: LogFields | undefined): void {
    const { budget, nowMs } = this.#ring;
    const line = budget.admit(level, message, fields, nowMs());
    if (line === undefined) return;
    const leftOut = budget.takeLeftOut();
    if (leftOut > 0) this.#pass('warn', { message: LEFT_OUT, fields: { lines: leftOut } });
    this.#pass(level, line);
  }

  #pass(level: LevelName, { message, fields }: BoundedLine): void {
    if (level !== 'debug' || this.#ring.keepsDebug) this.#keep(level, message, fields);
    this.#inner[level](message, fields);
  }

  #keep(level: LevelName, message: string, fields: LogFields): void {
    const ring = this.#ring;
    const kept = keptFields({ ...this.#fields, ...fields });
    const text = withoutSecrets(message);
    const length = kept.reduce(
      (sum, { name, value }) => sum + name.length + value.length,
      text.length,
    );
    ring.lines.push({
      number: ++ring.lastNumber,
      timeMs: ring.nowMs(),
      level: LEVELS[level],
      message: text,
      fields: kept,
      length,
    });
    ring.length += length;
    while (ring.lines.length > KEPT_LINES || ring.length > KEPT_CHARACTERS) {
      ring.length -= ring.lines.shift()!.length;
    }
  }
}

/** [EX-39] */
function keptFields(fields: LogFields): KeptLine['fields'] {
  const kept: KeptLine['fields'] = [];
  for (const [name, value] of Object.entries(fields)) {
    if (value === undefined || name === 'stack') continue;
    const text = SECRET_NAME.test(name) ? '***' : withoutSecrets(String(value));
    kept.push({ name, value: text });
  }
  return kept;
}

function withoutSecrets(text: string): string {
  return text.replace(SECRET_PARAMETER, '$1$2***');
}
