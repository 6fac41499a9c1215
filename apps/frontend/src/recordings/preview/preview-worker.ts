import { OutlineReader } from '@ubii/recording';
import { imageOf } from '../../graph/preview/image-of.ts';
import { thumbnail } from '../../graph/preview/thumbnail.ts';
import { openSource } from '../files/open-source.ts';
import type { PreviewReport, PreviewRequest } from './preview-messages.ts';
import { readPreview, type ReadPreview } from './read-preview.ts';

/** Reads previews of recordings beside the page. */
const tell = (report: PreviewReport, transfer: Transferable[] = []): void =>
  self.postMessage(report, { transfer });

async function answer({ key, source }: PreviewRequest): Promise<void> {
  const read = await readPreview(await OutlineReader.open(openSource(source)));
  tell({ kind: 'preview', key, preview: read.preview });
  if (!read.preview.hasPicture) return;
  const picture = await pictureOf(read).catch(() => undefined);
  tell({ kind: 'picture', key, picture }, picture ? [picture] : []);
}

async function pictureOf(read: ReadPreview): Promise<ImageBitmap | undefined> {
  const image = imageOf(await read.pictureRecord());
  const small = image && (await thumbnail(image));
  return small && createImageBitmap(small);
}

self.addEventListener('message', ({ data }: MessageEvent<PreviewRequest>) => {
  answer(data).catch((error: unknown) =>
    tell({
      kind: 'failed',
      key: data.key,
      message: error instanceof Error ? error.message : String(error),
    }),
  );
});
