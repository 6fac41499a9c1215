import type { RecordingFile } from '../storage/recording-storage.ts';

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
  /** Deletes a file. Does nothing when there is none. */
  delete(id: string): Promise<void>;
  /** Makes the upload of this id a file of the folder. @throws when there is none */
  takeUpload(id: string): Promise<void>;
  /** Free space on the disk, bytes; 0 when unknown. */
  freeBytes(): Promise<number>;
}
