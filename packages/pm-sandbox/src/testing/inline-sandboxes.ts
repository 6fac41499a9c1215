import type { Sandbox, SandboxEvents, SandboxFactory, SandboxRequest } from '../ports/sandbox.ts';
import type { ModuleFault } from '../ports/module-fault.ts';
import { checkSource } from '../worker/check-source.ts';
import type { Engine } from '../worker/engine.ts';
import { Instance, type GivenParts, type InstanceHost } from '../worker/instance.ts';
import { isFatal, ModuleError, moduleFault } from '../worker/module-error.ts';
import { evaluateLibrary } from '../worker/v8/evaluate-callback.ts';
import { createV8Engine } from '../worker/v8/v8-engine.ts';
import { WorkerAssets } from '../worker/worker-assets.ts';

/** Additions of a test. */
export interface InlineSandboxOptions {
  /** Libraries for `state.modules`, by name. */
  readonly libraries?: Readonly<Record<string, unknown>>;
  /** Reads the time for `durationMs`; default: no time passes. */
  readonly nowMs?: () => number;
}

/**
 * Sandboxes for tests: code runs at once, on the thread of the test, without any wall and any limit
 * of time. Inputs, outputs and faults are those of the real ones.
 */
export function createInlineSandboxes(options: InlineSandboxOptions = {}): SandboxFactory {
  return createEngineSandboxes(createV8Engine(), options);
}

/** The same with another engine. */
export function createEngineSandboxes(
  engine: Engine,
  options: InlineSandboxOptions = {},
): SandboxFactory {
  const { libraries = {}, nowMs = () => 0 } = options;
  const open = new Set<InlineSandbox>();
  const host: InstanceHost = {
    engine,
    nowMs,
    loadLibraries(names) {
      const missing = names.find((name) => !Object.hasOwn(libraries, name));
      if (missing !== undefined) {
        const message = `This node does not offer the library ${missing}.`;
        throw new ModuleError(moduleFault('library', 'onCreated', message));
      }
      return {
        modules: Object.fromEntries(names.map((name) => [name, libraries[name]])),
        hostLibraries: {},
        assets: {},
      };
    },
  };
  const hostOf = ({ assets }: SandboxRequest): InstanceHost => {
    const sets = assets.map((set) => new WorkerAssets(set, evaluateLibrary));
    return {
      ...host,
      loadLibraries(names) {
        const given = host.loadLibraries(names) as GivenParts;
        const own = sets.filter(({ isLibrary }) => isLibrary);
        return {
          ...given,
          modules: {
            ...given.modules,
            ...Object.fromEntries(own.map((set) => [set.name, set.library()])),
          },
          assets: Object.fromEntries(sets.map(({ name, files }) => [name, files])),
        };
      },
    };
  };
  return {
    open(request, events) {
      const sandbox = new InlineSandbox(request, events, hostOf(request), () =>
        open.delete(sandbox),
      );
      open.add(sandbox);
      return sandbox;
    },
    check: (source) => checkSource(engine, source),
    close() {
      for (const sandbox of open) sandbox.terminate();
      return Promise.resolve();
    },
  };
}

class InlineSandbox implements Sandbox {
  readonly #instance: Instance;
  readonly #events: SandboxEvents;
  readonly #onGone: () => void;
  readonly #pending = new Set<(fault: ModuleFault) => void>();
  #gone: ModuleFault | undefined;

  constructor(
    request: SandboxRequest,
    events: SandboxEvents,
    host: InstanceHost,
    onGone: () => void,
  ) {
    this.#events = events;
    this.#onGone = onGone;
    this.#instance = new Instance(request, host, {
      onLog: (level, text) => events.onLog({ level, text }),
      callHost: () => Promise.reject(new Error('tests have no host')),
      loadAssets: async (name) => {
        const set = await events.onLoadAssets!(name);
        return new WorkerAssets(set, evaluateLibrary).files;
      },
      onResume: () => undefined,
      onFailed: () => undefined,
    });
  }

  create(): Promise<void> {
    return this.#call(() => this.#instance.create());
  }

  run(call: Parameters<Sandbox['run']>[0]): ReturnType<Sandbox['run']> {
    return this.#call(() => this.#instance.run(call));
  }

  halt(): Promise<void> {
    return this.#call(() => this.#instance.halt());
  }

  async destroy(): Promise<void> {
    if (this.#gone !== undefined) return;
    try {
      await this.#call(() => this.#instance.destroy());
    } finally {
      this.terminate();
    }
  }

  terminate(): void {
    this.#end(moduleFault('crashed', '', 'The sandbox is closed.'));
  }

  #end(fault: ModuleFault): void {
    if (this.#gone !== undefined) return;
    this.#gone = fault;
    this.#instance.free();
    for (const reject of this.#pending) reject(this.#gone);
    this.#pending.clear();
    this.#onGone();
  }

  /** The code runs before this returns; what it awaits may be cut off by `terminate`. */
  #call<T>(call: () => T | Promise<T>): Promise<T> {
    return new Promise((resolve, reject) => {
      if (this.#gone !== undefined) {
        reject(this.#gone);
        return;
      }
      this.#pending.add(reject);
      const fail = (thrown: unknown): void => {
        const fault = thrown as ModuleFault;
        reject(fault);
        if (!isFatal(fault)) return;
        this.#end(fault);
        this.#events.onKilled(fault);
      };
      const end = (): void => void this.#pending.delete(reject);
      try {
        const called = call();
        if (called instanceof Promise) {
          called.then(resolve, fail).finally(end);
          return;
        }
        resolve(called);
      } catch (thrown) {
        fail(thrown);
      }
      end();
    });
  }
}
