import type { Config } from '../config/config.ts';
import type { Lan, Log } from '../../core/ports/index.ts';
import { openHttps, type Https } from '../tls/open-https.ts';
import { isLoopbackHost } from '../addresses/address-kinds.ts';
import type { Reach } from './listeners.ts';
import { ALL_NETWORKS } from './open-port.ts';

export interface LanSwitchContext {
  readonly config: Config;
  readonly log: Log;
  /** Listens on the same ports elsewhere. @throws when a port cannot be had; nothing has changed then */
  readonly move: (reach: Reach) => Promise<void>;
  /** Called when other machines can reach the master that could not before. */
  readonly onOpen: () => void;
}

/** Knows what the master listens on, and opens it to the local network while it runs [AC-47]. */
export class LanSwitch implements Lan {
  readonly #context: LanSwitchContext;
  #host: string;
  #https: Https | undefined;
  #opening: Promise<void> | undefined;

  private constructor(context: LanSwitchContext, host: string, https: Https | undefined) {
    this.#context = context;
    this.#host = host;
    this.#https = https;
  }

  /** @throws ConfigError when there is a certificate that cannot be used */
  static async create(context: LanSwitchContext): Promise<LanSwitch> {
    const { config, log } = context;
    const host = config.lan ? ALL_NETWORKS : config.host;
    return new LanSwitch(context, host, await openHttps(config, host, log));
  }

  /** Host to listen on, see `openPort`. */
  get host(): string {
    return this.#host;
  }

  /** HTTPS on its ports; undefined while it answers HTTP alone. */
  get https(): Https | undefined {
    return this.#https;
  }

  get isOpen(): boolean {
    return !isLoopbackHost(this.#host);
  }

  /** Callers at the same time wait for the same opening. */
  async open(): Promise<void> {
    if (this.isOpen) return;
    this.#opening ??= this.#open().finally(() => (this.#opening = undefined));
    await this.#opening;
  }

  close(): void {
    this.#https?.close();
  }

  async #open(): Promise<void> {
    const { config, log, move, onOpen } = this.#context;
    const https = this.#https ?? (await openHttps(config, ALL_NETWORKS, log));
    try {
      await move({ host: ALL_NETWORKS, onePort: https?.onePort });
    } catch (error) {
      if (https !== this.#https) https?.close();
      throw error;
    }
    this.#host = ALL_NETWORKS;
    this.#https = https;
    onOpen();
  }
}
