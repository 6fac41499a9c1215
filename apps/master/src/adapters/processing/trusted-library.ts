import { watchModuleFolder, type FolderWatch } from '@ubii/pm-sandbox/folder';
import { ModuleOrigin, type ProcessingModule } from '@ubii/proto';

import type { Log } from '../../core/ports/index.ts';
import { ConfigError } from '@ubii/program';

type LoadedFolder = FolderWatch['loaded'];

/** Modules the operator vouches for: those of the program, and those of the folder of `--modules` [PM-51]. */
export class TrustedLibrary {
  readonly #builtIn: readonly ProcessingModule[];
  readonly #log: Log;
  #modules: readonly ProcessingModule[];
  #watch: FolderWatch | undefined = undefined;

  private constructor(builtIn: readonly ProcessingModule[], log: Log) {
    this.#builtIn = builtIn.map((module) => from(module, ModuleOrigin.MODULE_ORIGIN_BUILT_IN));
    this.#modules = this.#builtIn;
    this.#log = log;
  }

  /**
   * @param folder watched from now on; undefined for none
   * @throws ConfigError when the folder cannot be read
   */
  static async open(
    builtIn: readonly ProcessingModule[],
    folder: string | undefined,
    log: Log,
  ): Promise<TrustedLibrary> {
    const library = new TrustedLibrary(builtIn, log);
    if (folder === undefined) return library;
    try {
      library.#watch = await watchModuleFolder(
        folder,
        (loaded) => library.#take(loaded),
        (error) =>
          log.warn('the folder of modules is no longer watched', {
            folder,
            reason: error.message,
          }),
      );
    } catch (error) {
      const reason = error instanceof Error ? error.message : String(error);
      throw new ConfigError(`The folder of --modules cannot be read: ${reason}`);
    }
    library.#take(library.#watch.loaded);
    return library;
  }

  /** The same list as long as nothing changes. Of two with one name, the operator's comes first. */
  modules(): readonly ProcessingModule[] {
    return this.#modules;
  }

  has(name: string): boolean {
    return this.#modules.some((module) => module.name === name);
  }

  close(): void {
    this.#watch?.close();
  }

  #take({ modules, problems }: LoadedFolder): void {
    for (const { file, message } of problems) {
      this.#log.warn('a file in the folder of modules is ignored', { file, reason: message });
    }
    const own = modules.map((module) => from(module, ModuleOrigin.MODULE_ORIGIN_FOLDER));
    const names = new Set(own.map(({ name }) => name));
    this.#modules = [...own, ...this.#builtIn.filter(({ name }) => !names.has(name))];
    this.#log.info('modules loaded', { count: own.length });
  }
}

function from(module: ProcessingModule, origin: ModuleOrigin): ProcessingModule {
  const { version = '', libraries = [], assets = [], optionalAssets = [] } = module.extension ?? {};
  const needs = { libraries, assets, optionalAssets };
  const extension = { version, ...needs, replaceable: false, origin, grantIds: [] };
  return { ...module, extension };
}
