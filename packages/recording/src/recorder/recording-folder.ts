import { RecordingKind, RecordingState } from '@ubii/proto';

import type { RecordingFile } from '../storage/recording-storage.ts';
import type { ListedFile } from './file-checker.ts';
import { AT_MASTER, WITHOUT_PAGE } from './file-facts.ts';

/** Why a file was rejected, and whose it is. It stands beside the file. [RC-45] */
export interface Rejection {
  /** A sentence. */
  readonly reason: string;
  /** As the upload was named; else empty. */
  readonly name: string;
  readonly author: string;
  readonly makerId: string;
  /** Epoch milliseconds. */
  readonly rejectedMs: number;
}

/** A file that is kept, and not read. */
export interface RejectedFile {
  readonly id: string;
  readonly sizeBytes: number;
  readonly rejection: Rejection;
}

/** A rejected file as the list has it. */
export function listRejected({ id, sizeBytes, rejection }: RejectedFile): ListedFile {
  const { reason, name, author, makerId, rejectedMs: startedMs } = rejection;
  const kind = RecordingKind.RECORDING_KIND_IMPORT;
  const state = RecordingState.RECORDING_STATE_REJECTED;
  const problem = `The file cannot be read. ${reason}`;
  return {
    facts: { makerId },
    recording: {
      id,
      name: name === '' ? id : name,
      kind,
      state,
      startedMs,
      sizeBytes,
      problem,
      author,
      notes: '',
      durationMs: 0,
      recordCount: 0,
      lostCount: 0,
      topicCount: 0,
      markerCount: 0,
      selection: undefined,
      study: undefined,
      budget: undefined,
      replayedRecordingId: '',
      ...WITHOUT_PAGE,
      ...AT_MASTER,
    },
  };
}

/** The text of a rejection, for the folder. */
export function formatRejection(rejection: Rejection): string {
  return `${JSON.stringify(rejection, undefined, 2)}\n`;
}

/** Reads it again. What is missing, or written by others, is empty. */
export function parseRejection(text: string): Rejection {
  const { reason, name, author, makerId, rejectedMs } = parseObject(text);
  return {
    reason: textOf(reason) || 'It was refused by an earlier check.',
    name: textOf(name),
    author: textOf(author),
    makerId: textOf(makerId),
    rejectedMs: typeof rejectedMs === 'number' ? rejectedMs : 0,
  };
}

function parseObject(text: string): Readonly<Record<string, unknown>> {
  try {
    const value: unknown = JSON.parse(text);
    return typeof value === 'object' && value !== null ? { ...value } : {};
  } catch {
    return {};
  }
}

function textOf(value: unknown): string {
  return typeof value === 'string' ? value.slice(0, 1000) : '';
}

/** A recording's file that is open. */
export interface OpenFile extends RecordingFile {
  close(): Promise<void>;
}

/** Where files of recordings are. Only the recorder uses it. */
export interface RecordingFolder {
  /** Ids of all files. */
  list(): Promise<readonly string[]>;
  has(id: string): Promise<boolean>;
  /** Creates a file for writing. @throws when it exists */
  create(id: string): Promise<OpenFile>;
  /** Opens a file for reading. @throws when there is none */
  open(id: string): Promise<OpenFile>;
  /** Opens a file for repair and changes. @throws when there is none */
  edit(id: string): Promise<OpenFile>;
  /** Deletes a file, also a rejected one. Does nothing when there is none. */
  delete(id: string): Promise<void>;
  /** Opens the upload of this id for repair and changes. @throws when there is none */
  editUpload(id: string): Promise<OpenFile>;
  /** Makes the upload of this id a file of the folder. @throws when there is none */
  takeUpload(id: string): Promise<void>;
  /** Deletes the upload of this id. Does nothing when there is none. */
  dropUpload(id: string): Promise<void>;
  /** Keeps a file, or an upload, so that it is not read any more. [RC-45] @throws when there is none */
  reject(id: string, from: 'recording' | 'upload', rejection: Rejection): Promise<RejectedFile>;
  /** All files that were rejected, in this run and before. */
  rejected(): Promise<readonly RejectedFile[]>;
  /** Free space on the disk, bytes; 0 when unknown. */
  freeBytes(): Promise<number>;
}
