import type { PreviousFault } from './backend-replacement.ts';
import { BACKEND_CHOICES, type BackendName } from './tensorflow/backend-names.ts';
import {
  sharedTensorflow,
  type Tensorflow,
  type WantedBackend,
} from './tensorflow/create-tensorflow.ts';
import type { Files } from './tensorflow/memory-platform.ts';

/** A model that can be chosen. */
export interface ModelSource<Model extends { dispose(): void }> {
  readonly title: string;
  /** Loads files that are not there from the start. Rejects with an error whose `code` is `missing` when they are not installed. */
  load(): Files | Promise<Files>;
  create(tensorflow: Tensorflow, files: Files): Promise<Model>;
}

/** Dependencies of a choice of models. */
export interface ModelSources<Name extends string, Model extends { dispose(): void }> {
  /** For `createTensorflow`. */
  readonly tensorflow: Files;
  /** By name; the first one is the default and replaces others. */
  readonly models: Readonly<Record<Name, ModelSource<Model>>>;
  /**
   * What ended the instance before this one, when it was restarted. A backend of the graphics card that takes longer for a
   * picture than a call may last would otherwise be tried again and again.
   */
  readonly previousFault?: PreviousFault | undefined;
  /** Called with one sentence about each model and backend that is used from now on. */
  onChange?(text: string): void;
  /** Milliseconds of a steady clock; default `performance.now`. */
  now?(): number;
  /** Default: the TensorFlow.js that the worker shares. */
  createTensorflow?(files: Files, backend: WantedBackend): Promise<Tensorflow>;
}

/** A model and a backend as the caller requested them. */
export interface ModelRequest<Name> {
  readonly model: Name;
  readonly backend: BackendName | 'auto';
  /** Why it differs from what the caller asked for; empty when it does not. */
  readonly problem: string;
}

/** Reads the names that a caller gives. Unknown names are a problem: then the model stays, and the backend is `auto`. */
export function readRequest<Name extends string, Model extends { dispose(): void }>(
  sources: ModelSources<Name, Model>,
  current: Name,
  model: string,
  backend: string,
): ModelRequest<Name> {
  const { models } = sources;
  const problems: string[] = [];
  const isModel = Object.hasOwn(models, model);
  if (!isModel) {
    problems.push(
      `There is no detector "${model}". There are ${namesOf(sources).join(' and ')}. ${models[current].title} detects.`,
    );
  }
  const isBackend = (BACKEND_CHOICES as readonly string[]).includes(backend);
  if (!isBackend) {
    problems.push(`There is no backend "${backend}". There are ${BACKEND_CHOICES.join(', ')}.`);
  }
  return {
    model: isModel ? (model as Name) : current,
    backend: isBackend ? (backend as ModelRequest<Name>['backend']) : 'auto',
    problem: problems.join(' '),
  };
}

/** Names of the models, the default one first. */
export function namesOf<Name extends string>(sources: {
  readonly models: Readonly<Record<Name, unknown>>;
}): readonly Name[] {
  return Object.keys(sources.models) as Name[];
}

/** TensorFlow.js on a backend, with the files of these sources. */
export function tensorflowOf<Name extends string, Model extends { dispose(): void }>(
  { tensorflow, createTensorflow = sharedTensorflow }: ModelSources<Name, Model>,
  backend: WantedBackend,
): Promise<Tensorflow> {
  return createTensorflow(tensorflow, backend);
}
