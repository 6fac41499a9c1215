export const PARTY_PATH = '/party';
export const PARTY_PHONE_PATH = '/party/play';
