import {
  createAssetStore,
  createHttpAssets,
  createModuleRuntime,
  type EncodedRecord,
  type TopicListener,
  type TopicPort,
  type TopicSelector,
  type AssetStore,
} from '@ubii/pm-sandbox';
import {
  DATA_FORMATS,
  encodeRecord,
  decodeRecord,
  fromJson,
  Image2DDataFormat,
  ProcessingModuleStatus,
  type Image2D,
  type IOMapping,
  type Object2DList,
} from '@ubii/proto';
import { systemClock } from '@ubii/client-web';
import { moduleLibrary } from '@ubii/modules';
import { createBrowserSandboxes } from '@ubii/pm-sandbox/browser';

import { sightingsOf, type Detector, type Pixels, type Sighting } from './detector.ts';

/** Calls a function for one value after the other: a result is that of its own value. */
export function inTurn<T, R>(act: (value: T) => Promise<R>): (value: T) => Promise<R> {
  let last: Promise<unknown> = Promise.resolve();
  return (value) => {
    const done = last.then(() => act(value));
    last = done.catch(() => undefined);
    return done;
  };
}

/** Topics inside of this page: pictures go to the module, and what it finds comes back. Nothing of it leaves. */
export class PageTopics implements TopicPort {
  readonly #listeners = new Map<string, TopicListener>();
  readonly #handleOutput: (topic: string, record: Uint8Array) => void;

  constructor(handleOutput: (topic: string, record: Uint8Array) => void) {
    this.#handleOutput = handleOutput;
  }

  subscribe(selector: TopicSelector, listener: TopicListener): () => void {
    if (selector.kind !== 'topic') throw new Error('This page has no patterns of topics.');
    this.#listeners.set(selector.topic, listener);
    return () => void this.#listeners.delete(selector.topic);
  }

  publish(topic: string, record: Uint8Array): undefined {
    this.#handleOutput(topic, record);
  }

  put(topic: string, value: Image2D): void {
    const record: EncodedRecord = {
      topic,
      bytes: encodeRecord({ topic, format: 'image2D', value }),
      valueField: DATA_FORMATS.image2D.fieldNumber,
      publisherId: '',
      isOwned: true,
    };
    this.#listeners.get(topic)?.onRecord(record);
  }
}

const MODULE = 'object-detection';
/** A phone that needs longer for one picture does not answer, milliseconds. */
const LONGEST_MS = 10_000;
const TAKES_TOO_LONG = 'The detector does not answer. Reload the page.';

/** Inputs and outputs of the module. Low scores are wanted, too: the game decides what is sure enough. */
const MAPPING = {
  processingModuleName: MODULE,
  inputMappings: [
    { inputName: 'image', topic: 'image' },
    { inputName: 'threshold', constantJson: '0.2' },
    { inputName: 'maxRate', constantJson: '240' },
  ],
  outputMappings: ['predictions', 'error'].map((name) => ({ outputName: name, topic: name })),
};

interface Waiting {
  resolve(sightings: readonly Sighting[]): void;
  reject(error: Error): void;
}

/**
 * The library's module `object-detection` in a worker of this page.
 *
 * @param onLoaded bytes of the asset sets that were loaded so far
 * @param masterUrl where they are loaded from
 */
export async function openDetector(
  onLoaded: (bytes: number) => void,
  masterUrl: () => string,
): Promise<Detector> {
  let waiting: Waiting | undefined;
  const settle = (act: (one: Waiting) => void): void => {
    const one = waiting;
    waiting = undefined;
    if (one) act(one);
  };
  const topics = new PageTopics((topic, bytes) => {
    const { value } = decodeRecord(bytes);
    if (topic === 'predictions')
      settle(({ resolve }) => resolve(sightingsOf(value as Object2DList)));
    // A fault of the backend is no fault of the picture: the predictions come as well
    else if (value !== '')
      setTimeout(() => settle(({ reject }) => reject(new Error(String(value)))));
  });
  const sandboxes = createBrowserSandboxes({ maxWorkers: 1 });
  const runtime = createModuleRuntime({
    nodeId: 'page',
    clock: systemClock,
    topics,
    patterns: {
      compile: () => {
        throw new Error('This page has no patterns.');
      },
    },
    sandboxes,
    assets: counted(createAssetStore(createHttpAssets(masterUrl)), onLoaded),
    onEvent: () => undefined,
    onStatus: (_id, status, fault) => {
      if (fault && status === ProcessingModuleStatus.DESTROYED)
        settle(({ reject }) => reject(new Error(fault.message)));
    },
  });
  const close = (): void => {
    settle(({ reject }) => reject(new Error('The detector was closed.')));
    void runtime.close().then(() => sandboxes.close());
  };
  try {
    const module = moduleLibrary().find(({ name }) => name === MODULE)!;
    const mapping: IOMapping = fromJson('ubii.sessions.IOMapping', MAPPING);
    await runtime.create({
      module: { ...module, id: MODULE, sessionId: 'hunt' },
      mapping,
      isTrusted: true,
    });
    runtime.start(MODULE);
  } catch (fault) {
    close();
    throw new Error((fault as { message: string }).message, { cause: fault });
  }
  return {
    close,
    // Another picture would get the result of the one before
    detect: inTurn(({ width, height, data }: Pixels) => {
      return new Promise((resolve, reject) => {
        const one = { resolve, reject };
        waiting = one;
        setTimeout(
          () => waiting === one && settle(() => reject(new Error(TAKES_TOO_LONG))),
          LONGEST_MS,
        );
        topics.put('image', {
          width,
          height,
          dataFormat: Image2DDataFormat.RGBA8,
          data: new Uint8Array(data),
        });
      });
    }),
  };
}

/** Reports how many bytes of all sets were loaded. */
function counted(store: AssetStore, onLoaded: (bytes: number) => void): AssetStore {
  const loaded = new Map<string, number>();
  return {
    load: (names, signal, onProgress) =>
      store.load(names, signal, (progress) => {
        loaded.set(progress.name, progress.loadedBytes);
        onLoaded([...loaded.values()].reduce((sum, bytes) => sum + bytes, 0));
        onProgress(progress);
      }),
  };
}
