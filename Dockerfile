# The program in an image: built from these sources, installed from the Debian package that they make.
#   docker build --tag aoscore .
#   docker run --rm --volume "$PWD:/work" aoscore score hall.glb
FROM debian:bookworm-slim AS build
WORKDIR /aoscore
COPY . .
RUN ./run.sh --version \
    && apt-get install --yes --no-install-recommends dpkg-dev \
    && cmake --build build/release \
    && cpack --config build/release/CPackConfig.cmake -B /packages

FROM debian:bookworm-slim
COPY --from=build /packages/*.deb /packages/
RUN apt-get update \
    && apt-get install --yes --no-install-recommends /packages/*.deb \
    && rm -rf /packages /var/lib/apt/lists/*
# Scenes are read from here, and results are written here.
WORKDIR /work
ENTRYPOINT ["aoscore"]
CMD ["--help"]
