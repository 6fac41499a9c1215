import { missingSet } from '../assets/asset-error.ts';
import type { LoadedAssets } from '../assets/asset-store.ts';
import type { ModuleFault } from '../ports/module-fault.ts';
import type {
  Sandbox,
  SandboxCall,
  SandboxEvents,
  SandboxRequest,
  SandboxResult,
} from '../ports/sandbox.ts';
import { sourceTooLong } from '../worker/check-source.ts';
import { moduleFault } from '../worker/module-error.ts';
import type { WorkerHost } from './worker-host.ts';

const NOT_CREATED = moduleFault('crashed', '', 'The sandbox is not created.');
const CLOSED = moduleFault('crashed', '', 'The sandbox is closed.');

/** An instance that lives in a worker of a pool. */
export class RemoteSandbox implements Sandbox {
  readonly #request: SandboxRequest;
  readonly #events: SandboxEvents;
  readonly #place: (request: SandboxRequest) => WorkerHost;
  readonly #onGone: (host: WorkerHost) => void;
  #home: { readonly host: WorkerHost; readonly number: number } | undefined;
  /** Why nothing can be called any more. */
  #gone: ModuleFault | undefined;

  constructor(
    request: SandboxRequest,
    events: SandboxEvents,
    place: (request: SandboxRequest) => WorkerHost,
    onGone: (host: WorkerHost) => void,
  ) {
    this.#request = request;
    this.#events = events;
    this.#place = place;
    this.#onGone = onGone;
  }

  async create(): Promise<void> {
    const fault = this.#gone ?? sourceTooLong(this.#request.source);
    if (fault !== undefined) throw fault;
    const host = this.#place(this.#request);
    const number = host.add({
      request: this.#request,
      onLog: (line) => this.#events.onLog(line),
      onMemory: (bytes) => this.#events.onMemory?.(bytes),
      loadAssets: (name) =>
        this.#events.onLoadAssets?.(name) ?? Promise.reject<LoadedAssets>(missingSet(name)),
      onKilled: (killed) => {
        this.#leave(killed);
        this.#events.onKilled(killed);
        this.#onGone(host);
      },
      onClosed: (closed) => this.#leave(closed),
    });
    this.#home = { host, number };
    try {
      await host.create(number);
    } catch (created) {
      this.#leave(created as ModuleFault);
      this.#free(host, number, created as ModuleFault);
      throw created;
    }
  }

  run(call: SandboxCall): Promise<SandboxResult> {
    const home = this.#home;
    return home === undefined
      ? Promise.reject<SandboxResult>(this.#gone ?? NOT_CREATED)
      : home.host.run(home.number, call);
  }

  async halt(): Promise<void> {
    if (this.#home === undefined) throw this.#gone ?? NOT_CREATED;
    await this.#home.host.halt(this.#home.number);
  }

  async destroy(): Promise<void> {
    const home = this.#home;
    if (home === undefined) return;
    try {
      await home.host.destroy(home.number);
    } finally {
      this.terminate();
    }
  }

  terminate(): void {
    const home = this.#home;
    this.#leave(CLOSED);
    if (home !== undefined) this.#free(home.host, home.number, CLOSED);
  }

  #free(host: WorkerHost, number: number, fault: ModuleFault): void {
    host.free(number, fault);
    this.#onGone(host);
  }

  #leave(fault: ModuleFault): void {
    this.#home = undefined;
    this.#gone ??= fault;
  }
}
