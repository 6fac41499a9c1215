import {
  ClientState,
  clientTopic,
  INFO_TOPICS,
  type Client as ClientMessage,
  type Device,
  type Init,
  type Mark,
} from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { Limits } from '../limits/index.ts';
import type { Account } from '../shares/account.ts';
import { RESOURCE } from '../shares/resources.ts';
import type { MasterPublisher } from './master-publisher.ts';
import { Hook } from '../hooks/hook.ts';
import { PacedAnnouncements } from './paced-announcements.ts';

/** Registrations of absent clients that are larger are announced in short: the announcement remains while they are away. */
const ABSENT_ANNOUNCEMENT_BYTES = 512;
/** Seconds of news of one client that may come at once. */
const BURST_SECONDS = 4;

/** A client as it is announced. */
export interface AnnouncedClient {
  readonly id: string;
  readonly account: Account;
  readonly registrationRevision: number;
  readonly mark: Mark | undefined;
  /** The master that it is at; undefined: this one. */
  readonly home: { readonly masterId: string } | undefined;
  toMessage(): Omit<ClientMessage, 'extension'>;
}

/** A client as others see it: with its mark, and in a cluster with its master. */
export type DescribedClient = ReturnType<AnnouncedClient['toMessage']> & {
  readonly extension?: { readonly masterId: string; readonly mark: Mark | undefined };
};

/** Announces who comes, changes and goes. */
export class InfoTopics {
  /** A client came or changed. */
  readonly onClient = new Hook<[client: AnnouncedClient]>();
  /** A client is gone. */
  readonly onClientGone = new Hook<[client: AnnouncedClient]>();
  readonly #publisher: MasterPublisher;
  readonly #limits: Limits;
  readonly #masterId: string | undefined;
  readonly #ofClients: PacedAnnouncements;

  /** @param masterId of this master in a cluster; undefined for one that is alone */
  constructor(
    publisher: MasterPublisher,
    clock: Clock,
    limits: Limits,
    masterId: string | undefined,
  ) {
    this.#masterId = masterId;
    this.#publisher = publisher;
    this.#limits = limits;
    const { clientNewsBytesPerSecond: bytesPerSecond } = limits;
    const burstBytes = BURST_SECONDS * bytesPerSecond;
    this.#ofClients = new PacedAnnouncements(clock, { bytesPerSecond, burstBytes });
  }

  /** [CL-30] */
  announceDevice(device: Device): void {
    this.#publisher.publish(INFO_TOPICS.newDevice, { device });
  }

  /** [CL-30] */
  announceDeviceGone(device: Device): void {
    this.#publisher.publish(INFO_TOPICS.deleteDevice, { device });
  }

  /** [CL-31] [EX-74] [EX-75] */
  announceClient(client: AnnouncedClient): void {
    const topic = clientTopic(client.id);
    this.onClient.emit(client);
    this.#ofClients.announce(client.id, () =>
      this.#publisher.publishChange(topic, { client: this.#messageOf(client, true) }),
    );
  }

  /** The last news of a client, which is removed [CL-31]. */
  announceClientGone(client: AnnouncedClient): void {
    const topic = clientTopic(client.id);
    this.onClientGone.emit(client);
    this.#ofClients.forget(client.id);
    this.#publisher.publish(topic, { client: this.#messageOf(client) });
    this.#publisher.deleteValue(topic);
  }

  /** The client as others see it, with its mark, and in a cluster with its master. [EX-100] [CU-70] */
  describe(client: AnnouncedClient): DescribedClient {
    return this.#withExtension(client.toMessage(), client);
  }

  /** Ends every timer. */
  close(): void {
    this.#ofClients.close();
  }

  /**
   * The client as it is announced: as a whole, or what can be told in a few bytes [EX-74].
   *
   * @param isKept the announcement remains on its topic
   */
  #messageOf(client: AnnouncedClient, isKept = false): Init<ClientMessage> {
    const bytes = client.account.used(RESOURCE.registrationBytes);
    const message = client.toMessage();
    const isAway = isKept && message.state === ClientState.UNAVAILABLE;
    const maxBytes = isAway ? ABSENT_ANNOUNCEMENT_BYTES : this.#limits.announcementBytes;
    if (bytes <= maxBytes) return this.#withExtension(message, client);
    const { id, name, state, latency, isDedicatedProcessingNode } = message;
    const { registrationRevision, mark } = client;
    return {
      id,
      name,
      state,
      latency,
      isDedicatedProcessingNode,
      extension: {
        abridged: true,
        registrationRevision,
        masterId: this.#masterOf(client) ?? '',
        mark,
      },
    };
  }

  #withExtension(message: DescribedClient, client: AnnouncedClient): DescribedClient {
    const masterId = this.#masterOf(client);
    const { mark } = client;
    if (masterId === undefined && mark === undefined) return message;
    return { ...message, extension: { masterId: masterId ?? '', mark } };
  }

  #masterOf({ home }: AnnouncedClient): string | undefined {
    return this.#masterId === undefined ? undefined : (home?.masterId ?? this.#masterId);
  }
}
