import { MemoryFile } from '@ubii/recording/testing';
import type { OpenFile, RecordingFolder, RejectedFile, Rejection } from '@ubii/recording/recorder';

/** A file in memory that stays when it is closed. */
export class MemoryRecording extends MemoryFile implements OpenFile {
  close(): Promise<void> {
    return Promise.resolve();
  }
}

/** Files of recordings in memory. */
export class MemoryFolder implements RecordingFolder {
  readonly files = new Map<string, MemoryRecording>();
  readonly uploads = new Map<string, MemoryRecording>();
  readonly rejectedFiles = new Map<string, RejectedFile>();
  /** Free space, bytes. */
  free = 1e12;
  /** Writes beyond this many bytes of a file fail, as on a full disk. */
  maxBytes = Infinity;

  list(): Promise<string[]> {
    return Promise.resolve([...this.files.keys()]);
  }

  has(id: string): Promise<boolean> {
    return Promise.resolve(this.files.has(id));
  }

  create(id: string): Promise<OpenFile> {
    const file = new MemoryRecording();
    file.maxBytes = this.maxBytes;
    this.files.set(id, file);
    return Promise.resolve(file);
  }

  open(id: string): Promise<OpenFile> {
    const file = this.files.get(id);
    return file === undefined ? Promise.reject(new Error('no such file')) : Promise.resolve(file);
  }

  edit(id: string): Promise<OpenFile> {
    return this.open(id);
  }

  delete(id: string): Promise<void> {
    this.files.delete(id);
    this.rejectedFiles.delete(id);
    return Promise.resolve();
  }

  editUpload(id: string): Promise<OpenFile> {
    const file = this.uploads.get(id);
    return file === undefined ? Promise.reject(new Error('no such upload')) : Promise.resolve(file);
  }

  dropUpload(id: string): Promise<void> {
    this.uploads.delete(id);
    return Promise.resolve();
  }

  async reject(
    id: string,
    from: 'recording' | 'upload',
    rejection: Rejection,
  ): Promise<RejectedFile> {
    const file = await (from === 'upload' ? this.editUpload(id) : this.open(id));
    (from === 'upload' ? this.uploads : this.files).delete(id);
    const rejected = { id, sizeBytes: Number(await file.size()), rejection };
    this.rejectedFiles.set(id, rejected);
    return rejected;
  }

  rejected(): Promise<readonly RejectedFile[]> {
    return Promise.resolve([...this.rejectedFiles.values()]);
  }

  takeUpload(id: string): Promise<void> {
    const file = this.uploads.get(id);
    if (file === undefined) return Promise.reject(new Error('no such upload'));
    this.files.set(id, file);
    this.uploads.delete(id);
    return Promise.resolve();
  }

  freeBytes(): Promise<number> {
    return Promise.resolve(this.free);
  }
}
