export { announceMaster, type AnnouncedMaster, type AnnounceOptions } from './announce-master.ts';
export type { Announcement } from './announcement.ts';
export { findMasters, type FindOptions, type FoundMaster } from './find-masters.ts';
export { ownAddresses, type MulticastOptions } from './open-responder.ts';
