export { gameSession } from './host/game-session.ts';
export type { HostMemory, HostStorage } from './host/host-memory.ts';
export { PartyHost, type PartyHostListener, type PartyHostOptions } from './host/party-host.ts';
export type * from './messages.ts';
export { MAX_PHOTO_BYTES, MAX_PHOTO_SIDE, type HiddenPhotos, type Photo } from './photos/photo.ts';
export { PartyPhone } from './phone/party-phone.ts';
export type { PhoneFacts, PhoneLink } from './phone/phone-link.ts';
export type * from './room-view.ts';
export * from './topics.ts';
