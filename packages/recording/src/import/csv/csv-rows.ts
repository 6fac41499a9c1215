import { RecordingError } from '../../records/recording-error.ts';
import type { BufferedSource } from '../buffered-source.ts';

/** A row of a CSV file. */
export interface CsvRow {
  /** Line of the file at which it begins, the first being 1. */
  readonly line: number;
  readonly cells: readonly string[];
  /** Bytes of the file that were read so far. */
  readonly readBytes: number;
}

export type Delimiter = ',' | ';' | '\t';

const PART_BYTES = 256 * 1024;
const MAX_CELL_LENGTH = 1024 * 1024;
const MAX_CELLS = 4096;

/** The character that separates most cells of the first line. */
export async function delimiterOf(source: BufferedSource): Promise<Delimiter> {
  const [line = ''] = new TextDecoder().decode(await source.read(0, PART_BYTES)).split(/\r?\n/, 1);
  const counts = ([',', ';', '\t'] as const).map(
    (each) => [each, line.split(each).length] as const,
  );
  return counts.reduce((best, one) => (one[1] > best[1] ? one : best))[0];
}

/**
 * Reads a CSV file (RFC 4180, UTF-8) row by row. Lines without content are left out.
 *
 * @throws RecordingError that names the line, when a quote has no end or a cell has more than 1 MiB
 */
export async function* csvRows(
  source: BufferedSource,
  delimiter: Delimiter,
): AsyncGenerator<CsvRow> {
  const decoder = new TextDecoder();
  const scan = new CsvScan(delimiter);
  for (let offset = 0; offset < source.size; offset += PART_BYTES) {
    const bytes = await source.read(offset, PART_BYTES);
    const readBytes = offset + bytes.byteLength;
    const text = decoder.decode(bytes, { stream: true });
    for (const row of scan.take(text)) yield { ...row, readBytes };
  }
  const row = scan.end(decoder.decode());
  if (row !== undefined) yield { ...row, readBytes: source.size };
}

type ScannedRow = Omit<CsvRow, 'readBytes'>;

/** Splits text that comes in parts into rows. */
class CsvScan {
  readonly #delimiter: string;
  #cells: string[] = [];
  #cell = '';
  #state: 'plain' | 'quoted' | 'quote' = 'plain';
  #line = 1;
  #rowLine = 1;

  constructor(delimiter: string) {
    this.#delimiter = delimiter;
  }

  *take(text: string): Generator<ScannedRow> {
    for (const character of text) {
      if (this.#state === 'quoted') {
        if (character === '"') this.#state = 'quote';
        else this.#add(character);
      } else if (character === '"' && (this.#state === 'quote' || this.#cell === '')) {
        if (this.#state === 'quote') this.#cell += '"';
        this.#state = 'quoted';
      } else if (character === this.#delimiter) this.#endCell();
      else if (character === '\n') {
        const row = this.#endRow();
        if (row !== undefined) yield row;
      } else if (character !== '\r') this.#add(character);
      if (character !== '\n') continue;
      this.#line++;
      if (this.#state !== 'quoted') this.#rowLine = this.#line;
    }
  }

  end(text: string): ScannedRow | undefined {
    const [row] = [...this.take(text)];
    if (this.#state === 'quoted') {
      throw new RecordingError(
        `Line ${this.#rowLine}: the quote has no end. Write a quote inside a cell as "".`,
      );
    }
    return row ?? this.#endRow();
  }

  #add(character: string): void {
    this.#cell += character;
    if (this.#cell.length > MAX_CELL_LENGTH) {
      throw new RecordingError(
        `Line ${this.#rowLine}, column ${this.#cells.length + 1}: the cell has more than 1 MiB.`,
      );
    }
  }

  #endCell(): void {
    // A mark of the byte order is no part of the first name.
    this.#cells.push(this.#cells.length === 0 ? this.#cell.replace(/^\uFEFF/, '') : this.#cell);
    this.#cell = '';
    this.#state = 'plain';
    if (this.#cells.length > MAX_CELLS) {
      throw new RecordingError(`Line ${this.#rowLine} has more than ${MAX_CELLS} cells.`);
    }
  }

  #endRow(): ScannedRow | undefined {
    this.#endCell();
    const [cells, line] = [this.#cells, this.#rowLine];
    this.#cells = [];
    return cells.every((cell) => cell === '') ? undefined : { line, cells };
  }
}
