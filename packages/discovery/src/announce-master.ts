import { SERVICE_TYPE, instanceName, toTxt } from './announcement.ts';
import type { Announcement } from './announcement.ts';
import { openResponder } from './open-responder.ts';
import type { MulticastOptions, ReceivedRecord, Responder } from './open-responder.ts';

/** Options for announcing a master. */
export interface AnnounceOptions extends MulticastOptions {
  readonly announcement: Announcement;
  /** Name under which the addresses of this machine are announced, such as `workshop.local`. */
  readonly host: string;
  /** Called once for each thing that goes wrong; the master does without. */
  readonly onProblem: (reason: string) => void;
  /** Called with the instance name whenever the master is announced under another one. */
  readonly onName?: (name: string) => void;
}

/** A master that is announced. */
export interface AnnouncedMaster {
  /** Takes it back; resolves within half a second. */
  close(): Promise<void>;
}

/** Time for other hosts to claim the name, milliseconds. */
const PROBE_MS = 750;
/** Interval of checks for changed networks of the computer, milliseconds. */
const NETWORKS_MS = 10_000;
/** Timeout of the goodbye message, milliseconds. */
const FAREWELL_MS = 400;
/** More masters of one name are not distinguished by their number. */
const MAX_ATTEMPTS = 100;

const TYPE_NAME = `_${SERVICE_TYPE}._tcp.local`;

/** Announces a master in the local networks until it is closed. Never throws. [DI-1] */
export function announceMaster(options: AnnounceOptions): AnnouncedMaster {
  const announced = new Announced(options);
  announced.open();
  return announced;
}

class Announced implements AnnouncedMaster {
  readonly #options: AnnounceOptions;
  readonly #watch: NodeJS.Timeout;
  readonly #told = new Set<string>();
  #responders: Responder[] = [];
  #probe: NodeJS.Timeout | undefined;
  #networks = '';
  #attempt = 1;
  #name = '';
  #isPublished = false;
  #isClosed = false;
  /** Ids of the masters that were heard, by instance name in lower case. */
  readonly #others = new Map<string, string>();

  constructor(options: AnnounceOptions) {
    this.#options = options;
    this.#watch = setInterval(() => this.#handleNetworks(), NETWORKS_MS);
    this.#watch.unref();
  }

  open(): void {
    const { addresses, port, onProblem } = this.#options;
    const here = [...addresses()];
    this.#networks = here.join();
    this.#isPublished = false;
    this.#responders = here.flatMap((address) => {
      const responder = openResponder(address, port, (reason) => {
        if (this.#isClosed || this.#told.has(reason)) return;
        this.#told.add(reason);
        onProblem(reason);
      });
      return responder ?? [];
    });
    for (const responder of this.#responders) {
      responder.onResponse((records) => this.#handleRecords(records));
      responder.query(TYPE_NAME, 'PTR');
    }
    this.#probe = setTimeout(() => this.#publish(), PROBE_MS);
    this.#probe.unref();
  }

  async close(): Promise<void> {
    if (this.#isClosed) return;
    this.#isClosed = true;
    clearInterval(this.#watch);
    await this.#leave();
  }

  #publish(): void {
    const { announcement, host, onName } = this.#options;
    this.#name = this.#freeName();
    this.#isPublished = true;
    for (const { bonjour } of this.#responders) {
      bonjour.publish({
        name: this.#name,
        type: SERVICE_TYPE,
        port: announcement.port,
        host,
        txt: toTxt(announcement),
        // The probe of the library would withdraw the records of the master that has the name.
        probe: false,
      });
    }
    if (this.#responders.length > 0) onName?.(this.#name);
  }

  /** [DI-3] */
  #freeName(): string {
    const { name } = this.#options.announcement;
    while (this.#attempt < MAX_ATTEMPTS) {
      const candidate = instanceName(name, this.#attempt);
      if (!this.#others.has(candidate.toLowerCase())) return candidate;
      this.#attempt += 1;
    }
    return instanceName(name, this.#attempt);
  }

  #handleRecords(records: readonly ReceivedRecord[]): void {
    for (const { type, name, data, ttl } of records) {
      if (type !== 'TXT' || !name.toLowerCase().endsWith(`.${TYPE_NAME}`)) continue;
      const instance = name.slice(0, -TYPE_NAME.length - 1).toLowerCase();
      const id = idOf(data);
      if (id === undefined || id === this.#options.announcement.id) continue;
      if (ttl === 0) {
        if (this.#others.get(instance) === id) this.#others.delete(instance);
        continue;
      }
      this.#others.set(instance, id);
      if (this.#isPublished && instance === this.#name.toLowerCase()) this.#handleRival(id);
    }
  }

  /** Two began at once: the one with the lesser id keeps the name. [DI-3] */
  #handleRival(id: string): void {
    if (this.#isClosed || this.#options.announcement.id < id) return;
    this.#isPublished = false;
    const responders = this.#responders;
    // Not taken back: the records of the other one have the same name.
    void Promise.all(responders.map((responder) => responder.close())).then(() => {
      if (!this.#isClosed) this.open();
    });
  }

  /** The machine went into another network, or out of one. */
  #handleNetworks(): void {
    if (this.#isClosed || [...this.#options.addresses()].join() === this.#networks) return;
    void this.#leave().then(() => {
      if (!this.#isClosed) this.open();
    });
  }

  async #leave(): Promise<void> {
    clearTimeout(this.#probe);
    const responders = this.#responders;
    this.#responders = [];
    let timer: NodeJS.Timeout | undefined;
    const timeUp = new Promise<void>((resolve) => (timer = setTimeout(resolve, FAREWELL_MS)));
    const taken = responders.map(
      ({ bonjour }) => new Promise<void>((resolve) => bonjour.unpublishAll(() => resolve())),
    );
    await Promise.race([Promise.all(taken), timeUp]);
    await Promise.race([Promise.all(responders.map((responder) => responder.close())), timeUp]);
    clearTimeout(timer);
  }
}

/** The id in the strings of a TXT record. */
function idOf(data: unknown): string | undefined {
  const strings = (Array.isArray(data) ? data : [data]) as unknown[];
  const texts = strings.map((one) => (one instanceof Uint8Array ? decoder.decode(one) : ''));
  return texts.find((text) => text.startsWith('id='))?.slice('id='.length);
}

const decoder = new TextDecoder();
