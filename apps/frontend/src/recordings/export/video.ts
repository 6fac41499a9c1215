import type { RecordedRecord } from '@ubii/recording';
import {
  BufferTarget,
  getFirstEncodableVideoCodec,
  Mp4OutputFormat,
  Output as VideoOutput,
  QUALITY_HIGH,
  VideoSample,
  VideoSampleSource,
  WebMOutputFormat,
  type VideoCodec,
} from 'mediabunny';
import { counted } from '@ubii/words';
import { imageOf } from '../../graph/preview/image-of.ts';
import { toDrawable } from '../../topics/viewers/picture/image-pixels.ts';
import { decodeRecorded } from '../reading/decode-recorded.ts';
import type { ExportReader } from './export-reader.ts';
import type { Output } from './output.ts';
import { evenSize, videoKind, type VideoKind } from './video-format.ts';

/** How long the last picture stands, seconds. */
const LAST_S = 0.1;
const NS_PER_S = 1e9;
const RECORDS_BETWEEN_PROGRESS = 20;

interface Size {
  readonly width: number;
  readonly height: number;
}

const CODECS: Readonly<Record<VideoKind, VideoCodec[]>> = { webm: ['vp9', 'vp8'], mp4: ['avc'] };

async function codecFor(kind: VideoKind, size: Size): Promise<VideoCodec> {
  const codec = await getFirstEncodableVideoCodec(CODECS[kind], size);
  if (codec !== null) return codec;
  throw new Error(`This browser cannot encode pictures of ${size.width} × ${size.height} pixels.`);
}

export interface VideoPart {
  readonly fromNs?: bigint;
  readonly untilNs?: bigint;
  readonly signal: AbortSignal;
  readonly onProgress: (records: number) => void;
}

/**
 * Writes the pictures of a topic as a video. Each stands as long as it was the last one of the topic, by the time at which
 * it reached the recorder.
 *
 * @returns what was left out, as sentences
 * @throws when there is no picture or the browser cannot encode it
 */
export async function writeVideo(
  reader: ExportReader,
  topic: string,
  output: Output,
  part: VideoPart,
): Promise<readonly string[]> {
  const fromNs = part.fromNs ?? reader.summary.startNs;
  let encoder: Encoder | undefined;
  let [count, broken] = [0, 0];
  try {
    for await (const { record, logTimeNs } of picturesOf(reader, topic, fromNs, part.untilNs)) {
      part.signal.throwIfAborted();
      if (++count % RECORDS_BETWEEN_PROGRESS === 0) part.onProgress(count);
      const picture = await pictureOf(topic, record);
      if (picture === undefined) broken++;
      else {
        encoder ??= await Encoder.start(picture);
        await encoder.show(picture, Number(logTimeNs - fromNs) / NS_PER_S);
      }
    }
    if (encoder === undefined)
      throw new Error(`${topic} has no picture in this span that can be shown.`);
    await output.write(await encoder.end());
  } catch (error) {
    await encoder?.cancel();
    throw error;
  }
  return broken === 0 ? [] : [`${topic}: ${counted(broken, 'picture')} could not be decoded.`];
}

/** The picture that stands when the span begins, and those of the span. */
async function* picturesOf(
  reader: ExportReader,
  topic: string,
  fromNs: bigint,
  untilNs: bigint | undefined,
): AsyncGenerator<RecordedRecord> {
  const standing = (await reader.latestAt(fromNs - 1n, [topic])).get(topic);
  if (standing !== undefined) yield { ...standing, logTimeNs: fromNs };
  yield* reader.records({ topics: [topic], fromNs, untilNs });
}

async function pictureOf(topic: string, bytes: Uint8Array): Promise<ImageBitmap | undefined> {
  const image = imageOf(decodeRecorded(topic, bytes));
  try {
    const drawable = image && (await toDrawable(image));
    return drawable && (await createImageBitmap(drawable));
  } catch {
    return undefined;
  }
}

/** Encodes pictures of any size into a video of one size. */
class Encoder {
  readonly #canvas: OffscreenCanvas;
  readonly #context: OffscreenCanvasRenderingContext2D;
  readonly #video: VideoOutput<Mp4OutputFormat | WebMOutputFormat, BufferTarget>;
  readonly #source: VideoSampleSource;
  /** When what is on the canvas was shown: black, until the first picture comes. */
  #shownAt = 0;

  private constructor({ width, height }: Size, kind: VideoKind, codec: VideoCodec) {
    this.#canvas = new OffscreenCanvas(width, height);
    this.#context = this.#canvas.getContext('2d', { alpha: false })!;
    this.#source = new VideoSampleSource({ codec, quality: QUALITY_HIGH });
    const format = kind === 'mp4' ? new Mp4OutputFormat() : new WebMOutputFormat();
    this.#video = new VideoOutput({ format, target: new BufferTarget() });
    this.#video.addVideoTrack(this.#source);
  }

  /** @param first gives the size of the video */
  static async start(first: Size): Promise<Encoder> {
    const size = evenSize(first);
    const kind = await videoKind();
    const encoder = new Encoder(size, kind, await codecFor(kind, size));
    await encoder.#video.start();
    return encoder;
  }

  /** Shows a picture from a moment on, which is closed. @param atS seconds */
  async show(picture: ImageBitmap, atS: number): Promise<void> {
    // Of several pictures at the same moment, the last one is shown.
    if (atS > this.#shownAt) await this.#encode(atS);
    this.#draw(picture);
    this.#shownAt = Math.max(atS, this.#shownAt);
  }

  async end(): Promise<Uint8Array> {
    await this.#encode(this.#shownAt + LAST_S);
    await this.#video.finalize();
    return new Uint8Array(this.#video.target.buffer ?? new ArrayBuffer(0));
  }

  cancel(): Promise<void> {
    return this.#video.cancel();
  }

  async #encode(untilS: number): Promise<void> {
    const timestamp = this.#shownAt;
    const sample = new VideoSample(this.#canvas, { timestamp, duration: untilS - timestamp });
    try {
      await this.#source.add(sample);
    } finally {
      sample.close();
    }
  }

  /** Fits the picture into the video, with black bars where its sides differ. */
  #draw(picture: ImageBitmap): void {
    const { width, height } = this.#canvas;
    const context = this.#context;
    const scale = Math.min(width / picture.width, height / picture.height);
    const [w, h] = [picture.width * scale, picture.height * scale];
    context.fillStyle = 'black';
    context.fillRect(0, 0, width, height);
    context.drawImage(picture, (width - w) / 2, (height - h) / 2, w, h);
    picture.close();
  }
}
