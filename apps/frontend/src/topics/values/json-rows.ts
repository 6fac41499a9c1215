import type { JsonValue } from '@ubii/proto';

/** A line of a value written as a tree. */
export interface JsonRow {
  /** Where in the value it stands, `elements.0.id`; empty for the value itself. */
  readonly path: string;
  /** 1 for the outermost. */
  readonly level: number;
  /** The member's name or the element's index; empty for a value that is not in another. */
  readonly name: string;
  readonly kind: 'object' | 'array' | 'string' | 'number' | 'boolean' | 'null' | 'more';
  /** The value, or what a closed branch holds. */
  readonly text: string;
  readonly isBranch: boolean;
  readonly isOpen: boolean;
}

/** Members or elements of one branch that are listed; */
const MAX_CHILDREN = 100;
/** lines in all; */
const MAX_ROWS = 500;
/** and letters of one text. */
const MAX_TEXT = 1000;

/** Writes a value line by line. Bounded, whatever the value holds; what is left out is said. */
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
  // The members of the value itself stand at the left edge.
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

/** Numbers of single precision have seven digits; the rest is what is left over from the format. */
function numberText(value: number): string {
  const isSingle = Math.fround(value) === value && !Number.isInteger(value);
  return String(isSingle ? Number(value.toPrecision(7)) : value).replaceAll('-', '−');
}

const cut = (text: string, length: number): string =>
  text.length > length ? `${text.slice(0, length)}…` : text;
