import type { Clock } from '@ubii/timing';
import { BridgeEngine } from './engine/bridge-engine.ts';
import type { EngineReport } from './engine/bridge-engine.ts';
import type { HomeAssistant } from './home-assistant/home-assistant.ts';
import { EchoMemory } from './loop/echo-memory.ts';
import type { OtherBridges } from './loop/other-bridges.ts';
import type { Mapping } from './mapping/mapping.ts';
import type { PayloadCodec } from './payload/payload-codec.ts';
import type { ForeignState, ForeignSystem } from './ports/foreign-system.ts';
import type { TopicMaster } from './ports/topic-master.ts';

/** How a bridge does, as it says on its topic. [BR-33] */
export interface BridgeReport extends EngineReport {
  readonly status: ForeignState['status'];
  readonly reason?: string;
  readonly homeAssistant?: { readonly entities: number; readonly skipped: number };
}

/** Arguments of `createBridgeLink`. */
export interface BridgeLinkContext<P> {
  readonly clock: Clock;
  readonly master: TopicMaster;
  readonly bridges: OtherBridges;
  readonly system: ForeignSystem<P>;
  readonly codec: PayloadCodec<P>;
  /** The system sends back what it gets, without saying who sent it. */
  readonly returnsMessages: boolean;
  onState(state: ForeignState): void;
}

/** A master and another system, connected by mappings, whatever its messages are. */
export interface BridgeLink {
  open(): void;
  setMappings(mappings: readonly Mapping[]): void;
  setAvailable(isAvailable: boolean): void;
  report(): BridgeReport;
  close(): Promise<void>;
}

/** Connects the engine and the adapter of a system. @param homeAssistant only where messages are bytes */
export function createBridgeLink<P>(
  context: BridgeLinkContext<P>,
  homeAssistant?: P extends Uint8Array ? HomeAssistant : never,
): BridgeLink {
  const { clock, master, bridges, system, codec } = context;
  let state: ForeignState = { status: 'connecting' };
  const engine = new BridgeEngine<P>({
    clock,
    codec,
    master,
    bridges,
    echoes: context.returnsMessages ? new EchoMemory(clock) : undefined,
    foreign: {
      send: (message) => system.send(message),
      setMappings: (mappings) =>
        system.setMappings(
          homeAssistant === undefined ? mappings : [...mappings, ...homeAssistant.subscriptions],
        ),
    },
  });
  return {
    open() {
      system.open({
        handleMessage(message) {
          if (homeAssistant?.handleMessage(message as never) !== true) {
            engine.handleMessage(message);
          }
        },
        handleRefused: (reason) => engine.handleRefused(reason),
        handleDropped: (mapping, reason) => engine.handleDropped(mapping, reason),
        handleState(next) {
          state = next;
          if (next.status === 'connected' && next.hasForgotten) homeAssistant?.announceAgain();
          engine.handleState(next);
          context.onState(next);
        },
        handleSettled: () => engine.handleSettled(),
      });
    },
    setMappings: (mappings) =>
      engine.setMappings([...mappings, ...(homeAssistant?.mappings ?? [])]),
    setAvailable: (isAvailable) => system.setAvailable(isAvailable),
    report: () => ({
      status: state.status,
      ...('reason' in state && { reason: state.reason }),
      ...engine.report(),
      ...(homeAssistant && { homeAssistant: homeAssistant.counts }),
    }),
    async close() {
      engine.close();
      homeAssistant?.close();
      await system.close();
    },
  };
}
