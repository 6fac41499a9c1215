import { NEXT_BACKEND, replacementOf, sentence, suspicionOf } from './backend-replacement.ts';
import {
  namesOf,
  readRequest,
  tensorflowOf,
  type ModelRequest,
  type ModelSources,
} from './model-sources.ts';
import type { BackendName } from './tensorflow/backend-names.ts';
import type { Tensorflow } from './tensorflow/create-tensorflow.ts';

/** Interval of requests for missing files of a model, milliseconds. */
const RETRY_MS = 5_000;

interface Loaded<Name, Model> {
  readonly name: Name;
  readonly model: Model;
  readonly tensorflow: Tensorflow;
}

/**
 * One model and one backend out of several, which can be changed while it computes: the model in use
 * stays until the next one is loaded. What is not available is replaced, and `problem` says why.
 */
export class ModelChoice<Name extends string, Model extends { dispose(): void }> {
  readonly #sources: ModelSources<Name, Model>;
  readonly #names: readonly Name[];
  #inUse: Loaded<Name, Model>;
  /** The latest request of the caller. */
  #asked: string;
  #request: ModelRequest<Name>;
  #problem = '';
  /** Why backends failed while they computed, as in `backendFault`. */
  readonly #failures = new Map<BackendName, string>();
  /** The fastest backend is measured after the first result. */
  #isUnmeasured = true;
  /** Why the graphics card is not used until it is chosen again; undefined when it may be. */
  #suspicion: string | undefined;
  #following: Promise<void> | undefined;
  #retryAtMs = Infinity;
  #isDisposed = false;

  /**
   * Starts with the first model on the backend that starts soonest.
   * @throws Error when no backend works, or its files are damaged
   */
  static async create<Name extends string, Model extends { dispose(): void }>(
    sources: ModelSources<Name, Model>,
  ): Promise<ModelChoice<Name, Model>> {
    const name = namesOf(sources)[0]!;
    const tensorflow = await tensorflowOf(sources, 'soonest');
    const { create, load } = sources.models[name];
    const model = await create(tensorflow, await load());
    return new ModelChoice(sources, { name, model, tensorflow });
  }

  private constructor(sources: ModelSources<Name, Model>, inUse: Loaded<Name, Model>) {
    this.#sources = sources;
    this.#names = namesOf(sources);
    this.#inUse = inUse;
    this.#asked = `${inUse.name} auto`;
    this.#request = { model: inUse.name, backend: 'auto', problem: '' };
    this.#suspicion = suspicionOf(sources.previousFault);
    if (this.#suspicion !== undefined && inUse.tensorflow.isProvisional) {
      this.#isUnmeasured = false;
      this.#failures.set('webgl', replacementOf('auto', this.backend, this.#suspicion)!.fault);
    }
    this.#report();
  }

  get name(): Name {
    return this.#inUse.name;
  }

  get model(): Model {
    return this.#inUse.model;
  }

  get backend(): BackendName {
    return this.#inUse.tensorflow.backend;
  }

  /** The backends that failed, initially or later, the reasons, and their replacements; empty when none did. */
  get backendFault(): string {
    const { trials, backend } = this.#inUse.tensorflow;
    return trials
      .filter(({ outcome }) => outcome === 'failed' || outcome === 'wrong')
      .map(({ name, reason }) => `${name} does not work: ${reason} ${backend} replaces it.`)
      .concat(...this.#failures.values())
      .join(' ');
  }

  /** Why model or backend are not those that were chosen, for people; empty when they are. */
  get problem(): string {
    return this.#problem;
  }

  /**
   * Chooses model and backend, which are loaded meanwhile. The same choice again does nothing, except to
   * look again for files that were missing.
   *
   * @param backend `auto`, `webgpu`, `webgl`, `wasm` or `cpu`
   */
  choose(model: string, backend: string): void {
    const asked = `${model} ${backend}`;
    if (asked !== this.#asked) {
      this.#asked = asked;
      this.#request = this.#withoutSuspects(readRequest(this.#sources, this.name, model, backend));
      this.#isUnmeasured = false;
    } else if (this.#now() < this.#retryAtMs) return;
    this.#retryAtMs = Infinity;
    void this.#follow();
  }

  /**
   * Runs a task with the model in use. When its backend fails, the task is run again on the next one: no
   * input is lost.
   */
  async use<Result>(task: (model: Model) => Promise<Result>): Promise<Result> {
    const used = this.#inUse;
    try {
      const result = await task(used.model);
      if (this.#isUnmeasured && used.tensorflow.isProvisional && !this.#isDisposed) {
        this.#isUnmeasured = false;
        void this.#follow();
      }
      return result;
    } catch (error) {
      const { backend } = used.tensorflow;
      const next = NEXT_BACKEND[backend];
      // A picture or a class is wrong; or nothing is left to be tried.
      if (error instanceof RangeError || next === undefined || this.#isDisposed) throw error;
      if (this.#inUse === used) await this.#fallBack(backend, next, error);
      return this.use(task);
    }
  }

  /** Resolves when nothing is being loaded. */
  async settled(): Promise<void> {
    await this.#following;
  }

  dispose(): void {
    this.#isDisposed = true;
    this.#inUse.model.dispose();
  }

  /** The first choice of a restarted instance is that of before, and not that of a person who tries again. */
  #withoutSuspects(request: ModelRequest<Name>): ModelRequest<Name> {
    const suspicion = this.#suspicion;
    this.#suspicion = undefined;
    if (suspicion === undefined) return request;
    this.#failures.clear();
    const replacement = replacementOf(request.backend, this.backend, suspicion);
    if (replacement === undefined) return request;
    this.#failures.set('webgl', replacement.fault);
    return { ...request, ...replacement, problem: request.problem || replacement.problem };
  }

  async #fallBack(backend: BackendName, next: BackendName, error: unknown): Promise<void> {
    const reason = messageOf(error);
    this.#isUnmeasured = false;
    const problem = `The backend ${backend} failed: ${reason} ${next} is used instead.`;
    this.#failures.set(backend, `${backend} failed during use: ${reason} ${next} replaces it.`);
    this.#request = { ...this.#request, backend: next, problem };
    await this.#follow();
    // Nothing replaces it: it must not be asked again and again.
    if (this.backend === backend) throw error;
  }

  /** Loads one after the other the requests until the newest one is in use. */
  #follow(): Promise<void> {
    this.#following ??= (async () => {
      for (let request: ModelRequest<Name> | undefined; request !== this.#request;) {
        request = this.#request;
        const problems = await this.#apply(request);
        this.#problem = [request.problem, ...problems].filter(Boolean).join(' ');
      }
    })().finally(() => (this.#following = undefined));
    return this.#following;
  }

  /** @returns what did not work */
  async #apply({ model, backend }: ModelRequest<Name>): Promise<string[]> {
    const problems: string[] = [];
    let tensorflow: Tensorflow;
    try {
      tensorflow = await tensorflowOf(this.#sources, backend);
    } catch (error) {
      return [messageOf(error)];
    }
    if (backend !== 'auto' && tensorflow.backend !== backend) problems.push(tensorflow.reason);
    try {
      await this.#load(model, tensorflow);
    } catch (error) {
      problems.push(this.#whyNot(model, error));
      // On the chosen backend anyway.
      await this.#load(this.#names[0]!, tensorflow).catch((other: unknown) =>
        problems.push(messageOf(other)),
      );
    }
    return problems;
  }

  async #load(name: Name, tensorflow: Tensorflow): Promise<void> {
    const before = this.#inUse;
    if (before.name === name && before.tensorflow.instance === tensorflow.instance) {
      this.#inUse = { ...before, tensorflow };
      return;
    }
    const { create, load } = this.#sources.models[name];
    const model = await create(tensorflow, await load());
    if (this.#isDisposed) return model.dispose();
    this.#inUse = { name, model, tensorflow };
    this.#failures.delete(tensorflow.backend);
    this.#report();
    // After a task under way. A backend that is lost took the memory of its models along.
    await before.tensorflow
      .run(() => before.model.dispose())
      .catch(() => before.model.dispose())
      .catch(() => undefined);
  }

  #whyNot(name: Name, error: unknown): string {
    const { title } = this.#sources.models[name];
    const substitute = this.#sources.models[this.#names[0]!].title;
    const isMissing = (error as { code?: unknown } | null)?.code === 'missing';
    if (!isMissing) {
      const problem = `${title} cannot be used: ${messageOf(error)}`;
      return title === substitute ? problem : `${problem} ${substitute} detects instead.`;
    }
    this.#retryAtMs = this.#now() + RETRY_MS;
    return `The model of ${title} is not installed. Download it on the page of this module, or with "npm run models -- get ${name}" on the computer of the master. Until then, ${substitute} detects.`;
  }

  #report(): void {
    const { name, tensorflow } = this.#inUse;
    const { title } = this.#sources.models[name];
    this.#sources.onChange?.(`${title} uses ${tensorflow.backend}. ${tensorflow.reason}`);
  }

  #now(): number {
    return this.#sources.now?.() ?? performance.now();
  }
}

function messageOf(error: unknown): string {
  return sentence(error instanceof Error ? error.message : String(error));
}
