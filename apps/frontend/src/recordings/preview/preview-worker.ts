import { OutlineReader } from '@ubii/recording';
import { serveCalls, transfer } from '@ubii/worker-rpc/browser';
import { imageOf } from '../../graph/preview/image-of.ts';
import { thumbnail } from '../../graph/preview/thumbnail.ts';
import { openSource } from '../files/open-source.ts';
import type { PreviewWorker } from './preview-messages.ts';
import { readPreview, type ReadPreview } from './read-preview.ts';

/** Previews whose picture was not read yet. */
const withPicture = new Map<string, ReadPreview>();

/** Reads previews of recordings beside the page. */
serveCalls<PreviewWorker>({
  async readPreview({ key, source }) {
    const read = await readPreview(await OutlineReader.open(openSource(source)));
    if (read.preview.hasPicture) withPicture.set(key, read);
    return read.preview;
  },
  async readPicture(key) {
    const read = withPicture.get(key);
    withPicture.delete(key);
    const picture = read && (await pictureOf(read).catch(() => undefined));
    return picture && transfer(picture);
  },
});

async function pictureOf(read: ReadPreview): Promise<ImageBitmap | undefined> {
  const image = imageOf(await read.pictureRecord());
  const small = image && (await thumbnail(image));
  return small && createImageBitmap(small);
}
