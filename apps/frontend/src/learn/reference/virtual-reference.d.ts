declare module 'virtual:learn-reference' {
  /** Data that learn-reference-plugin.js extracts from the sources during the build. */
  export const reference: {
    readonly messages: Readonly<
      Record<
        string,
        {
          readonly comment: string;
          readonly fields: Readonly<
            Record<
              string,
              { readonly comment: string; readonly number: number; readonly type: string }
            >
          >;
        }
      >
    >;
    readonly serviceRights: Readonly<
      Record<
        string,
        {
          readonly roles: readonly string[] | 'anyone';
          readonly audited: boolean;
        }
      >
    >;
    readonly topicRights: readonly {
      readonly topics: string;
      readonly publish: readonly string[];
      readonly receive: readonly string[];
    }[];
    readonly paths: readonly {
      readonly method: string;
      readonly path: string;
      readonly content: string;
    }[];
    readonly sockets: readonly { readonly path: string; readonly content: string }[];
    readonly closeCodes: readonly (readonly string[])[];
    readonly guides: readonly (readonly string[])[];
    readonly glossary: readonly (readonly string[])[];
  };
}
