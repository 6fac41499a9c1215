import type { JsonValue } from '@ubii/proto';

/** Line of a value displayed as a tree. */
export interface JsonRow {
  /** Path in the value, `elements.0.id`; empty for the value itself. */
  readonly path: string;
  /** 1 for the outermost. */
  readonly level: number;
  /** Name of the member or index of the element; empty for the value itself. */
  readonly name: string;
  readonly kind: 'object' | 'array' | 'string' | 'number' | 'boolean' | 'null' | 'more';
  /** The value, or a summary of a collapsed branch. */
  readonly text: string;
  readonly isBranch: boolean;
  readonly isOpen: boolean;
}

/** Most members or elements listed per branch; */
const MAX_CHILDREN = 100;
/** most lines in total; */
const MAX_ROWS = 500;
/** longest text, characters. */
const MAX_TEXT = 1000;

/** Formats a value as lines. Bounded for any value; says what is omitted. */
export function jsonRows(
  value: JsonValue,
  isOpen: (path: string, level: number) => boolean,
): JsonRow[] {
  const rows: JsonRow[] = [];
  const visit = (child: JsonValue, name: string, path: string, level: number): void => {
    if (rows.length >= MAX_ROWS) return;
    if (typeof child !== 'object' || child === null) {
      rows.push({ path, level, name, ...leaf(child), isBranch: false, isOpen: false });
      return;
    }
    const entries = Object.entries(child);
    const isArray = Array.isArray(child);
    const isBranch = entries.length > 0;
    const isExpanded = isBranch && isOpen(path, level);
    const count = isArray ? `${entries.length}` : entries.map(([key]) => key).join(', ');
    rows.push({
      path,
      level,
      name,
      kind: isArray ? 'array' : 'object',
      text: isArray ? `[${isBranch ? count : ''}]` : `{${cut(count, 80)}}`,
      isBranch,
      isOpen: isExpanded,
    });
    if (!isExpanded) return;
    for (const [key, member] of entries.slice(0, MAX_CHILDREN)) {
      visit(member as JsonValue, key, path === '' ? key : `${path}.${key}`, level + 1);
    }
    const left = entries.length - MAX_CHILDREN;
    if (left > 0) rows.push(more(path, level + 1, left));
  };
  // The members of the value itself are not indented.
  if (typeof value === 'object' && value !== null && Object.keys(value).length > 0) {
    const entries = Object.entries(value);
    for (const [key, member] of entries.slice(0, MAX_CHILDREN)) {
      visit(member as JsonValue, key, key, 1);
    }
    if (entries.length > MAX_CHILDREN) rows.push(more('', 1, entries.length - MAX_CHILDREN));
  } else {
    visit(value, '', '', 1);
  }
  return rows;
}

const more = (path: string, level: number, count: number): JsonRow => ({
  path: `${path}.…`,
  level,
  name: '',
  kind: 'more',
  text: `${count} more`,
  isBranch: false,
  isOpen: false,
});

function leaf(value: string | number | boolean | null): Pick<JsonRow, 'kind' | 'text'> {
  if (value === null) return { kind: 'null', text: 'null' };
  if (typeof value === 'string')
    return { kind: 'string', text: JSON.stringify(cut(value, MAX_TEXT)) };
  if (typeof value === 'boolean') return { kind: 'boolean', text: String(value) };
  return { kind: 'number', text: numberText(value) };
}

/** Single-precision numbers have seven significant digits; further ones are artefacts of the conversion. */
function numberText(value: number): string {
  const isSingle = Math.fround(value) === value && !Number.isInteger(value);
  return String(isSingle ? Number(value.toPrecision(7)) : value).replaceAll('-', '−');
}

const cut = (text: string, length: number): string =>
  text.length > length ? `${text.slice(0, length)}…` : text;
