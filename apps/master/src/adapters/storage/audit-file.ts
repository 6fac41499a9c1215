import { mkdirSync, readFileSync } from 'node:fs';
import { appendFile, rename } from 'node:fs/promises';
import { join } from 'node:path';

import { SECRET_MODE } from '@ubii/program';
import type { AuditStore, Log } from '../../core/ports/index.ts';

/** Lines that wait to be written at most: of more, while a disk hangs, the newest are lost. */
const MAX_WAITING = 10_000;

export interface AuditFileContext {
  readonly folder: string;
  /** A file with so many lines becomes the one before; that one goes. */
  readonly maxLines: number;
  readonly log: Log;
}

/** Lines in two alternating files, readable by the operator only [EX-92]. */
export class AuditFile implements AuditStore {
  readonly #context: AuditFileContext;
  readonly #current: string;
  readonly #before: string;
  #lines: string[];
  /** In the current file. */
  #lineCount = 0;
  #isCutOff = false;
  #waiting: string[] = [];
  #lost = 0;
  #written: Promise<void> = Promise.resolve();

  /** A folder that cannot be made or read is empty; what cannot be written is said in the log. */
  constructor(context: AuditFileContext) {
    this.#context = context;
    this.#current = join(context.folder, 'audit.jsonl');
    this.#before = join(context.folder, 'audit.1.jsonl');
    try {
      mkdirSync(context.folder, { recursive: true, mode: 0o700 });
    } catch (error) {
      context.log.warn('the audit log cannot be kept', { reason: String(error) });
    }
    const text = readText(this.#current);
    const lines = linesOf(text);
    this.#lineCount = lines.length;
    this.#isCutOff = text !== '' && !text.endsWith('\n');
    this.#lines = [...linesOf(readText(this.#before)), ...lines];
  }

  /** Once: the lines are not kept in memory twice. */
  read(): readonly string[] {
    const lines = this.#lines;
    this.#lines = [];
    return lines;
  }

  append(line: string): void {
    if (this.#waiting.length >= MAX_WAITING) {
      this.#lost++;
      return;
    }
    // The first that waits has all of them written, with those that come until its turn.
    if (this.#waiting.push(line) === 1) this.#written = this.#written.then(() => this.#write());
  }

  settled(): Promise<void> {
    return this.#written;
  }

  async #write(): Promise<void> {
    const lines = this.#waiting;
    this.#waiting = [];
    try {
      if (this.#lineCount > 0 && this.#lineCount + lines.length > this.#context.maxLines) {
        await rename(this.#current, this.#before);
        this.#lineCount = 0;
        this.#isCutOff = false;
      }
      const text = lines.map((line) => `${line}\n`).join('');
      await appendFile(this.#current, this.#isCutOff ? `\n${text}` : text, { mode: SECRET_MODE });
      this.#isCutOff = false;
      this.#lineCount += lines.length;
    } catch (error) {
      this.#lost += lines.length;
      // It is not known how much was written: start the next line with a line break.
      this.#isCutOff = true;
      this.#context.log.warn('entries of the audit log were not kept', {
        entries: this.#lost,
        reason: String(error),
      });
      this.#lost = 0;
    }
  }
}

function readText(file: string): string {
  try {
    return readFileSync(file, 'utf8');
  } catch {
    return '';
  }
}

function linesOf(text: string): string[] {
  return text.split('\n').filter((line) => line !== '');
}
