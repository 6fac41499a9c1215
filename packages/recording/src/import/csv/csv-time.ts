/** How a column tells times. */
export type TimeUnit = 's' | 'ms' | 'us' | 'ns' | 'iso';

/** Decimals of a nanosecond. */
const DECIMALS: Readonly<Record<Exclude<TimeUnit, 'iso'>, number>> = { s: 9, ms: 6, us: 3, ns: 0 };

const ISO =
  /^(\d{4}-\d\d-\d\d)(?:[T ](\d\d:\d\d)(?::(\d\d)(?:[.,](\d+))?)?)?\s*(Z|[+-]\d\d:?\d\d)?$/;

/** Nanoseconds of a time; without a zone it is UTC. Undefined when it is none. */
export function parseTimeNs(text: string, unit: TimeUnit): bigint | undefined {
  const trimmed = text.trim();
  return unit === 'iso' ? parseIso(trimmed) : parseDecimal(trimmed, DECIMALS[unit]);
}

function parseIso(text: string): bigint | undefined {
  const [, date, minutes = '00:00', seconds = '00', decimals = '', zone = 'Z'] =
    ISO.exec(text) ?? [];
  if (date === undefined) return undefined;
  const zoned = zone === 'Z' ? zone : zone.replace(/^(...):?/, '$1:');
  const ms = Date.parse(`${date}T${minutes}:${seconds}${zoned}`);
  if (Number.isNaN(ms)) return undefined;
  return BigInt(ms) * 1_000_000n + BigInt(decimals.padEnd(9, '0').slice(0, 9));
}

/** A decimal number without the loss of a double. */
function parseDecimal(text: string, scale: number): bigint | undefined {
  const match = /^([+-]?)(\d*)(?:[.,](\d*))?(?:[eE]([+-]?\d{1,3}))?$/.exec(text);
  if (match === null) return undefined;
  const [, sign, whole = '', part = '', exponent = '0'] = match;
  if (whole === '' && part === '') return undefined;
  const places = whole.length + scale + Number(exponent);
  const digits = `${whole}${part}`;
  const shown = places <= 0 ? '0' : digits.padEnd(places, '0').slice(0, places);
  const ns = BigInt(shown);
  return sign === '-' ? -ns : ns;
}

const NAME = /^(time|timestamp|t|date|datetime|utc|epoch|unix|zeit)([ _.\-(\][]|stamp|$)/i;
const UNIT_OF_NAME = /(?:^|[ _.\-([])(ns|us|µs|ms|s|sec|seconds?|millis|milliseconds?)[)\]]?$/i;

/** Whether a column is named as times are. */
export const isTimeName = (name: string): boolean => NAME.test(name.trim());

/** The unit of a column, by its name, else by its values. Undefined when they are no times. */
export function unitOf(name: string, values: readonly string[]): TimeUnit | undefined {
  const known = values.filter((value) => value.trim() !== '');
  if (known.length === 0) return undefined;
  if (known.every((value) => parseTimeNs(value, 'iso') !== undefined)) return 'iso';
  if (!known.every((value) => parseTimeNs(value, 's') !== undefined)) return undefined;
  const [, unit] = UNIT_OF_NAME.exec(name.trim()) ?? [];
  if (unit !== undefined) return unitOfWord(unit.toLowerCase());
  const first = Math.abs(Number(known[0]!.replace(',', '.')));
  // Numbers of this size are times since 1970, of the years from 2001 on.
  if (first >= 1e18) return 'ns';
  if (first >= 1e15) return 'us';
  return first >= 1e12 ? 'ms' : 's';
}

function unitOfWord(word: string): TimeUnit {
  if (word === 'ns') return 'ns';
  if (word === 'us' || word === 'µs') return 'us';
  return word.startsWith('ms') || word.startsWith('milli') ? 'ms' : 's';
}

/** Times before 1973 count from the beginning of the recording and not from 1970. */
export const isRelative = (timeNs: bigint): boolean => timeNs < 100_000_000_000_000_000n;
