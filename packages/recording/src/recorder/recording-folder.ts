import type { RecordingFile } from '../storage/recording-storage.ts';
import type { RejectedFile, Rejection } from './rejected-file.ts';

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
