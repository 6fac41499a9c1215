export { announceMaster } from './announce-master.ts';
export type { AnnouncedMaster, AnnounceOptions } from './announce-master.ts';
export type { Announcement } from './announcement.ts';
export { findMasters } from './find-masters.ts';
export type { FindOptions, FoundMaster } from './find-masters.ts';
export type { MulticastOptions } from './open-responder.ts';
export { ownAddresses } from './own-addresses.ts';
