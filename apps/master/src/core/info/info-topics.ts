import { clientTopic, INFO_TOPICS, type Device } from '@ubii/proto';
import type { Client } from '../clients/client.ts';
import type { MasterPublisher } from './master-publisher.ts';

/** Announces who comes, changes and goes. */
export class InfoTopics {
  readonly #publisher: MasterPublisher;

  constructor(publisher: MasterPublisher) {
    this.#publisher = publisher;
  }

  /** [CL-30] */
  announceDevice(device: Device): void {
    this.#publisher.publish(INFO_TOPICS.newDevice, { device });
  }

  /** [CL-30] */
  announceDeviceGone(device: Device): void {
    this.#publisher.publish(INFO_TOPICS.deleteDevice, { device });
  }

  /** [CL-31] */
  announceClient(client: Client): void {
    this.#publisher.publish(clientTopic(client.id), { client: client.toMessage() });
  }

  /** The last news of a client, which is removed [CL-31]. */
  announceClientGone(client: Client): void {
    this.announceClient(client);
    this.#publisher.deleteValue(clientTopic(client.id));
  }
}
