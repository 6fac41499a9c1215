/** Packs a folder as npm does, with the same bytes for the same files: a tar archive, compressed with gzip. */
export function packFolder(folder: string): Buffer;
