export { gameSession } from './host/game-sessions.ts';
export { PartyHost } from './host/party-host.ts';
export type {
  HostMemory,
  HostStorage,
  PartyHostListener,
  PartyHostOptions,
} from './host/party-host-options.ts';
export type { LiveRound, LiveRow } from './live-round.ts';
export { PartyPhone } from './phone/party-phone.ts';
export type { PhoneFacts, PhoneLink } from './phone/phone-link.ts';
export * from './protocol.ts';
