export type { PhoneFacts, PhoneLink } from './phone-link.ts';
