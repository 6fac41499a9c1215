import { saveBlob } from '../../files/save-file.ts';
import { fetchFile, type MasterFile } from './readable-file.ts';

/** A link cannot show who follows it: the page requests the file, and saves it. */
export async function downloadFile(file: MasterFile, name: string): Promise<void> {
  const response = await fetchFile(file);
  if (!response.ok) {
    throw new Error(`The master answered ${response.status} ${response.statusText}.`);
  }
  saveBlob(name, await response.blob());
}
