import { createHash } from 'node:crypto';
import type { UbiiClient } from '@ubii/client-web/node';
import { systemClock } from '@ubii/timing/system';
import { createTopicMaster } from './adapters/master/client-topic-master.ts';
import { watchDevices } from './adapters/master/watch-devices.ts';
import { createMqttSystem } from './adapters/mqtt/mqtt-system.ts';
import { oscCodec } from './adapters/osc/osc-codec.ts';
import { createOscSystem } from './adapters/osc/osc-system.ts';
import { rosCodec } from './adapters/rosbridge/ros-codec.ts';
import { createRosbridgeSystem } from './adapters/rosbridge/rosbridge-system.ts';
import { createBridgeLink } from './core/bridge-link.ts';
import type { BridgeLink, BridgeLinkContext } from './core/bridge-link.ts';
import { HomeAssistant } from './core/home-assistant/home-assistant.ts';
import type { OtherBridges } from './core/loop/other-bridges.ts';
import type { SeenAddresses } from './core/engine/seen-addresses.ts';
import type { MappingFile } from './core/mapping/read-mapping-file.ts';
import { bytesCodec } from './core/payload/bytes-codec.ts';
import type { Credentials } from './credentials.ts';
import type { Target } from './options.ts';

/** Arguments of `createLink`. */
export interface LinkContext {
  readonly client: UbiiClient;
  readonly target: Target;
  readonly bridges: OtherBridges;
  readonly credentials: Credentials;
  readonly ca: Buffer | undefined;
  /** UDP port for OSC. */
  readonly listen: number | undefined;
  /** The file as it is now. */
  file(): MappingFile;
  /** Collects the addresses of incoming messages. */
  readonly seen: SeenAddresses;
  /** Whether this bridge passes the mappings. [BR-24] */
  isActive(): boolean;
  masterId(): string;
  readonly onState: BridgeLinkContext<unknown>['onState'];
  onError(error: unknown): void;
}

/** A link that follows the mapping file. */
export interface RunningLink extends BridgeLink {
  /** The mapping file has changed. */
  refresh(): void;
}

/** Creates the link for the protocol of the target. */
export function createLink(context: LinkContext): RunningLink {
  switch (context.target.protocol) {
    case 'mqtt':
      return mqttLink(context);
    case 'osc':
      return oscLink(context);
    case 'rosbridge':
      return rosbridgeLink(context);
  }
}

function sharedOptions({ client, bridges, onState }: LinkContext) {
  return { clock: systemClock, master: createTopicMaster(client), bridges, onState };
}

function mqttLink(context: LinkContext): RunningLink {
  const { client, target, credentials, ca } = context;
  const { homeAssistant: settings, availability = defaultAvailability(client.name) } =
    context.file();
  const system = createMqttSystem({
    url: target.url,
    ...credentials,
    ca,
    availability,
    clientId: `ubii-${createHash('sha256').update(client.id).digest('hex').slice(0, 16)}`,
    masterId: context.masterId,
    isMasterOfCluster: (id) => context.bridges.isMaster(id),
  });
  const homeAssistant =
    settings &&
    new HomeAssistant({
      settings,
      availability,
      clock: systemClock,
      ownId: () => client.id,
      send: (message) => void system.send(message),
      onChange: () => refresh(),
    });
  const link = createBridgeLink(
    {
      ...sharedOptions(context),
      system: context.seen.watch(system),
      codec: bytesCodec,
      returnsMessages: false,
    },
    homeAssistant,
  );
  const refresh = (): void => {
    homeAssistant?.setActive(context.isActive());
    link.setMappings(mappingsOf(context));
  };
  let unwatch: (() => void) | undefined;
  return {
    ...link,
    refresh,
    open() {
      link.open();
      refresh();
      if (homeAssistant === undefined) return;
      unwatch = watchDevices(
        client,
        (devices) => homeAssistant.handleDevices(devices),
        context.onError,
      );
    },
    close() {
      unwatch?.();
      return link.close();
    },
  };
}

function oscLink(context: LinkContext): RunningLink {
  const { host, port } = context.target;
  const system = createOscSystem({ host, port, listen: context.listen, clock: systemClock });
  return followFile(context, { system: context.seen.watch(system), codec: oscCodec });
}

function rosbridgeLink(context: LinkContext): RunningLink {
  const { url } = context.target;
  const system = createRosbridgeSystem({
    url,
    ...context.credentials,
    ca: context.ca,
    clock: systemClock,
  });
  return followFile(context, { system: context.seen.watch(system), codec: rosCodec });
}

/** What this bridge passes: nothing while another one does. [BR-24] */
function mappingsOf({ file, isActive }: LinkContext): MappingFile['mappings'] {
  return isActive() ? file().mappings : [];
}

/** Creates a link to a system that sends back what it gets; its mappings are those of the file. */
function followFile<P>(
  context: LinkContext,
  system: Pick<BridgeLinkContext<P>, 'system' | 'codec'>,
): RunningLink {
  const link = createBridgeLink({ ...sharedOptions(context), ...system, returnsMessages: true });
  const refresh = (): void => link.setMappings(mappingsOf(context));
  return {
    ...link,
    refresh,
    open() {
      link.open();
      refresh();
    },
  };
}

/** `hall bridge` -> `ubii/hall-bridge/status` */
function defaultAvailability(name: string): string {
  return `ubii/${name.toLowerCase().replace(/[^a-z0-9]+/g, '-')}/status`;
}
