import type { LoadedAssets } from '../assets/asset-store.ts';
import { describeThrown, ModuleError, moduleFault } from './module-error.ts';

/** One asset set in a worker: one copy for all its instances. [PM-91] */
export class WorkerAssets {
  readonly name: string;
  /** Without the script of a library. */
  readonly files: LoadedAssets['files'];
  readonly isLibrary: boolean;
  readonly #evaluate: ((script: string, sourceUrl: string) => unknown) | undefined;
  #script: Uint8Array | undefined;
  #library: unknown;

  constructor(
    { name, library, files }: LoadedAssets,
    evaluate: ((script: string, sourceUrl: string) => unknown) | undefined,
  ) {
    const { [library ?? '']: script, ...others } = files;
    this.name = name;
    this.files = Object.freeze(others);
    this.isLibrary = library !== undefined;
    this.#script = script;
    this.#evaluate = evaluate;
  }

  /**
   * The value of its script, which is evaluated once.
   * @throws ModuleError when the script throws, or may not be evaluated here
   */
  library(): unknown {
    const script = this.#script;
    if (script === undefined) return this.#library;
    const failed = (why: string): ModuleError =>
      new ModuleError(
        moduleFault('library', 'onCreated', `The library ${this.name} cannot be loaded: ${why}.`),
      );
    if (this.#evaluate === undefined) throw failed('only trusted modules get libraries');
    try {
      const text = new TextDecoder().decode(script);
      this.#library = this.#evaluate(text, `ubii-library-${this.name}.js`);
    } catch (thrown) {
      throw failed(describeThrown(thrown));
    }
    this.#script = undefined;
    return this.#library;
  }
}
